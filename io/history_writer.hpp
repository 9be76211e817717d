#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "partition/communicator.hpp"

namespace cracksim::io {

/// One line of history.csv. Energies in J, crack_area in m2.
struct HistoryRow {
    std::int64_t step;
    double time;  ///< s
    double kinetic;
    double elastic;
    double dissipated;
    double external;
    std::int64_t inactive_duplets;
    std::int64_t unions;
    std::int64_t fragments;
    std::int64_t components;
    double crack_area;
};

/// About the size of history.csv with so many rows, bytes; numbers differ in length.
[[nodiscard]] std::int64_t history_bytes(std::int64_t rows);

/// Writes history.csv, a line at a time: after each call the line is in the file.
class HistoryWriter {
public:
    /// Makes the file with its header line. Throws FileError on all ranks alike. The communicator must outlive the writer. Collective.
    HistoryWriter(const partition::Communicator& comm, std::filesystem::path file);

    /// The root's row counts. Throws FileError on all ranks alike. Collective.
    void write(const HistoryRow& row);

private:
    struct Close {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };

    const partition::Communicator* comm_;
    std::filesystem::path file_;
    std::unique_ptr<std::FILE, Close> stream_;
};

}  // namespace cracksim::io
