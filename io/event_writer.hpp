#pragma once

#include <filesystem>
#include <span>

#include "io/worker.hpp"
#include "io/split_parts.hpp"
#include "partition/communicator.hpp"
#include "physics/events.hpp"

namespace cracksim::io {

/// Size of events.hdf with so many events, and parts that hold so many masses together, bytes.
[[nodiscard]] std::int64_t event_file_bytes(std::int64_t events, std::int64_t parts, std::int64_t masses);

/// Writes events.hdf: /events/{step,time,mass_a,mass_b}, one row an inactivated duplet, and /splits/{step,time,union,first,count},
/// one row a part that a split left: `union` is the smallest mass id of the union before the split, and the part's masses are
/// /splits/masses[first, first + count). Ids are global, int64; times are step * dt, s.
/// The file is opened and closed for each append, so it is whole in between and whoever reads it does no harm.
class EventWriter {
public:
    /// dt: the step, s. With a background, the root writes there, and what fails is told by it. The communicator and the
    /// background must outlive the writer, and the writer the background's jobs. Touches no file.
    EventWriter(const partition::Communicator& comm, std::filesystem::path file, double dt,
                Worker* worker = nullptr);

    /// Adds this rank's new events and parts; all of them must be later than those added before. They are written in order of
    /// (step, mass_a, mass_b) and (step, union, first mass); what several ranks give is written once. The first call makes the file
    /// if there is none, also without events. Throws FileError on all ranks alike. Collective.
    void append(std::span<const physics::DupletEvent> events, const SplitParts& parts) const;

private:
    void append_on_root(std::span<const physics::DupletEvent> events, const SplitParts& parts) const;

    const partition::Communicator* comm_;
    std::filesystem::path file_;
    double dt_;
    Worker* worker_;
};

}  // namespace cracksim::io
