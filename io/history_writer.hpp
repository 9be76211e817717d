#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "partition/communicator.hpp"

namespace cracksim::io {

/// One line of history.csv. Energies in J.
struct HistoryRow {
    struct Support {
        Vec3 force;         ///< on the block, N
        Vec3 displacement;  ///< mean of the masses that it holds, m
        double work;        ///< on the block, J
    };

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
    double crack_area;      ///< m2
    double residual;        ///< initial energy + external - (kinetic + elastic + dissipated)
    double scale;           ///< the energy put in
    Vec3 momentum;          ///< kg m/s
    Vec3 angular_momentum;  ///< about the origin, kg m2/s
    std::vector<Support> supports;
};

/// Estimated size of history.csv with `rows` rows, bytes; the lengths of the numbers vary.
[[nodiscard]] std::int64_t history_bytes(std::int64_t rows, std::span<const std::string> supports);

/// Writes history.csv line by line: when write() returns, the line is in the file.
class HistoryWriter {
public:
    /// Creates the file with its header line. supports: the names of the supports, for columns like NAME.force_x.
    /// Throws FileError on all ranks. The communicator must outlive the writer. Collective.
    HistoryWriter(const partition::Communicator& comm, std::filesystem::path file,
                  std::span<const std::string> supports);

    /// Writes the root's row; the rows of the other ranks are ignored. Throws FileError on all ranks. Collective.
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
