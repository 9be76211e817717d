#include "io/history_writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cinttypes>

#include "io/collective_errors.hpp"
#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

constexpr const char* columns =
    "step,time,kinetic,elastic,dissipated,external,inactive_duplets,unions,fragments,components,crack_area,residual,"
    "scale,momentum_x,momentum_y,momentum_z,angular_momentum_x,angular_momentum_y,angular_momentum_z";
constexpr const char* columns_of_support[] = {"force_x",        "force_y",        "force_z", "displacement_x",
                                              "displacement_y", "displacement_z", "work"};

/// A field of a CSV file (RFC 4180): in quotation marks if it contains a separator.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string{c};
    }
    return quoted + "\"";
}

std::string header(std::span<const std::string> supports) {
    std::string line = columns;
    for (const std::string& support : supports) {
        for (const char* column : columns_of_support) {
            line += "," + field(support + "." + column);
        }
    }
    return line + "\n";
}

// With 17 digits every double reads back to the same bits.
bool print(std::FILE* stream, double value) { return std::fprintf(stream, ",%.17g", value) > 0; }
bool print(std::FILE* stream, std::int64_t value) { return std::fprintf(stream, ",%" PRId64, value) > 0; }
bool print(std::FILE* stream, Vec3 v) { return print(stream, v.x) && print(stream, v.y) && print(stream, v.z); }
bool print(std::FILE* stream, const HistoryRow::Support& support) {
    return print(stream, support.force) && print(stream, support.displacement) && print(stream, support.work);
}

template <class... Values>
bool print_all(std::FILE* stream, const Values&... values) {
    return (print(stream, values) && ...);
}

bool print(std::FILE* stream, const HistoryRow& row) {
    const auto print_support = [&](const HistoryRow::Support& support) { return print(stream, support); };
    return std::fprintf(stream, "%" PRId64, row.step) > 0 &&
           print_all(stream, row.time, row.kinetic, row.elastic, row.dissipated, row.external, row.inactive_duplets,
                     row.unions, row.fragments, row.components, row.crack_area, row.residual, row.scale, row.momentum,
                     row.angular_momentum) &&
           std::ranges::all_of(row.supports, print_support) && std::fputc('\n', stream) != EOF;
}

}  // namespace

// A non-zero double takes about 20 characters; a typical row has a time, four energies and six counts, six momenta, and
// for each support seven numbers, three of them zero.
std::int64_t history_bytes(std::int64_t rows, std::span<const std::string> supports) {
    const auto typical_row = static_cast<std::int64_t>(280 + 90 * supports.size());
    return static_cast<std::int64_t>(header(supports).size()) + rows * typical_row;
}

HistoryWriter::HistoryWriter(const partition::Communicator& comm, std::filesystem::path file,
                             std::span<const std::string> supports)
    : comm_{&comm}, file_{std::move(file)} {
    on_root(*comm_, [&] {
        stream_.reset(std::fopen(file_.c_str(), "w"));
        if (!stream_) {
            throw file_error("create", file_, errno);
        }
        if (std::fputs(header(supports).c_str(), stream_.get()) < 0 || std::fflush(stream_.get()) != 0) {
            throw file_error("write", file_, errno);
        }
    });
}

void HistoryWriter::write(const HistoryRow& row) {
    on_root(*comm_, [&] {
        if (!print(stream_.get(), row) || std::fflush(stream_.get()) != 0) {
            throw file_error("write", file_, errno);
        }
    });
}

}  // namespace cracksim::io
