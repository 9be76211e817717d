#include "io/history_writer.hpp"

#include <cerrno>
#include <cinttypes>
#include <string_view>

#include "io/collective_errors.hpp"
#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

constexpr const char* header =
    "step,time,kinetic,elastic,dissipated,external,inactive_duplets,unions,fragments,components,crack_area\n";

// With 17 digits every double reads back to the same bits.
int print(std::FILE* stream, const HistoryRow& row) {
    return std::fprintf(
        stream, "%" PRId64 ",%.17g,%.17g,%.17g,%.17g,%.17g,%" PRId64 ",%" PRId64 ",%" PRId64 ",%" PRId64 ",%.17g\n",
        row.step, row.time, row.kinetic, row.elastic, row.dissipated, row.external, row.inactive_duplets, row.unions,
        row.fragments, row.components, row.crack_area);
}

}  // namespace

// A non-zero double takes about 20 characters; a typical row has a time, three energies and six counts.
std::int64_t history_bytes(std::int64_t rows) {
    constexpr std::int64_t typical_row = 110;
    return static_cast<std::int64_t>(std::string_view{header}.size()) + rows * typical_row;
}

HistoryWriter::HistoryWriter(const partition::Communicator& comm, std::filesystem::path file)
    : comm_{&comm}, file_{std::move(file)} {
    on_root(*comm_, [&] {
        stream_.reset(std::fopen(file_.c_str(), "w"));
        if (!stream_) {
            throw file_error("create", file_, errno);
        }
        if (std::fputs(header, stream_.get()) < 0 || std::fflush(stream_.get()) != 0) {
            throw file_error("write", file_, errno);
        }
    });
}

void HistoryWriter::write(const HistoryRow& row) {
    on_root(*comm_, [&] {
        if (print(stream_.get(), row) < 0 || std::fflush(stream_.get()) != 0) {
            throw file_error("write", file_, errno);
        }
    });
}

}  // namespace cracksim::io
