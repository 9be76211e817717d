#pragma once

#include <filesystem>
#include <span>

#include "io/split_parts.hpp"
#include "io/worker.hpp"
#include "partition/communicator.hpp"
#include "physics/events.hpp"

namespace cracksim::io {

/// Estimated size of events.hdf with these numbers of events and parts, bytes; `masses` counts the masses of all parts
/// together.
[[nodiscard]] std::int64_t event_file_bytes(std::int64_t events, std::int64_t parts, std::int64_t masses);

/// Writes events.hdf. /events/{step,time,mass_a,mass_b} has one row per inactivated duplet.
/// /splits/{step,time,union,first,count} has one row per part that a split left: `union` is the smallest mass id of the
/// union before the split, and the part's masses are /splits/masses[first, first + count). Ids are global, int64; times
/// are step * dt, s.
/// The file is opened and closed for each append, so between two appends it is complete and can be read safely.
class EventWriter {
public:
    /// dt: the time step, s. With a worker, the root writes in the worker's thread, and the worker throws the errors.
    /// The communicator and the worker must outlive the writer, and the writer must outlive the worker's jobs. Touches
    /// no file.
    EventWriter(const partition::Communicator& comm, std::filesystem::path file, double dt, Worker* worker = nullptr);

    /// Adds this rank's new events and parts; all of them must be later than those added before. Rows are written in
    /// order of (step, mass_a, mass_b) and (step, union, first mass); a row that several ranks add is written once. The
    /// first call creates the file if it does not exist, even without events. Without a worker, throws FileError on all
    /// ranks. Collective.
    void append(std::span<const physics::DupletEvent> events, const SplitParts& parts) const;

private:
    void append_on_root(std::span<const physics::DupletEvent> events, const SplitParts& parts) const;

    const partition::Communicator* comm_;
    std::filesystem::path file_;
    double dt_;
    Worker* worker_;
};

}  // namespace cracksim::io
