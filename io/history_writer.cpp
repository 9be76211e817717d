#include "io/history_writer.hpp"

#include <cerrno>
#include <cinttypes>

#include "io/agreement.hpp"
#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

constexpr const char* header =
    "step,time,kinetic,elastic,dissipated,external,inactive_duplets,unions,fragments,components,crack_area\n";

// 17 digits: every double reads back to the same bits.
int print(std::FILE* stream, const HistoryRow& row) {
    return std::fprintf(
        stream, "%" PRId64 ",%.17g,%.17g,%.17g,%.17g,%.17g,%" PRId64 ",%" PRId64 ",%" PRId64 ",%" PRId64 ",%.17g\n",
        row.step, row.time, row.kinetic, row.elastic, row.dissipated, row.external, row.inactive_duplets, row.unions,
        row.fragments, row.components, row.crack_area);
}

}  // namespace

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
