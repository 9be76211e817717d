#include "io/event_writer.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/sorted.hpp"
#include "io/collective_errors.hpp"
#include "io/file_error.hpp"
#include "io/hdf5.hpp"
#include "io/text_file.hpp"

namespace cracksim::io {

namespace {

using physics::DupletEvent;
using Integers = std::span<const std::int64_t>;
using Masses = std::span<const MassId>;

void create_file(const std::filesystem::path& path) {
    hdf5::File file{unfinished(path), hdf5::Access::create};
    file.create_group("/events");
    file.create_group("/splits");
    for (const char* name : {"/events/step", "/splits/step", "/splits/first", "/splits/count"}) {
        file.create_extendible<std::int64_t>(name);
    }
    for (const char* name : {"/events/mass_a", "/events/mass_b", "/splits/union", "/splits/masses"}) {
        file.create_extendible<MassId>(name);
    }
    file.create_extendible<double>("/events/time");
    file.create_extendible<double>("/splits/time");
    file.close();
    finish(path);
}

std::vector<double> times(Integers steps, double dt) {
    std::vector<double> result(steps.size());
    std::ranges::transform(steps, result.begin(), [dt](std::int64_t step) { return static_cast<double>(step) * dt; });
    return result;
}

void append_events(hdf5::File& file, std::span<const DupletEvent> events, double dt) {
    std::vector<std::int64_t> step;
    std::vector<MassId> mass_a;
    std::vector<MassId> mass_b;
    for (const DupletEvent& event : events) {
        step.push_back(event.step);
        mass_a.push_back(event.mass_a);
        mass_b.push_back(event.mass_b);
    }
    file.append("/events/step", Integers{step});
    file.append("/events/time", std::span<const double>{times(step, dt)});
    file.append("/events/mass_a", Masses{mass_a});
    file.append("/events/mass_b", Masses{mass_b});
}

void append_parts(hdf5::File& file, const SplitParts& parts, double dt) {
    std::vector<std::int64_t> first;
    std::int64_t next = file.rows("/splits/masses");
    for (const std::int64_t count : parts.count) {
        first.push_back(next);
        next += count;
    }
    file.append("/splits/masses", Masses{parts.masses});
    file.append("/splits/step", Integers{parts.step});
    file.append("/splits/time", std::span<const double>{times(parts.step, dt)});
    file.append("/splits/union", Masses{parts.parent});
    file.append("/splits/first", Integers{first});
    file.append("/splits/count", Integers{parts.count});
}

// An upper bound of the growth of the file: one more chunk per dataset, and twice the data because the chunk index
// grows too.
std::int64_t bytes(std::size_t events, const SplitParts& parts) {
    constexpr std::size_t chunks = std::size_t{10} * hdf5::chunk_rows * 8;
    const std::size_t data = 32 * events + 40 * parts.size() + 8 * parts.masses.size();
    return static_cast<std::int64_t>(chunks + 2 * data);
}

std::vector<DupletEvent> sorted(std::vector<DupletEvent> events) {
    sort_and_make_unique(events);
    return events;
}

SplitParts gather(const partition::Communicator& comm, const SplitParts& parts) {
    return {.step = comm.gather(Integers{parts.step}),
            .parent = comm.gather(Masses{parts.parent}),
            .count = comm.gather(Integers{parts.count}),
            .masses = comm.gather(Masses{parts.masses})};
}

}  // namespace

// HDF5 stores rows in chunks and lists the chunks in index nodes. The sizes of an empty file and of a node were
// measured with HDF5 1.10.
std::int64_t event_file_bytes(std::int64_t events, std::int64_t parts, std::int64_t masses) {
    const auto dataset = [](std::int64_t rows) {
        constexpr std::int64_t node = 2096;
        constexpr std::int64_t chunks_of_node = 56;
        const std::int64_t chunks = (rows + hdf5::chunk_rows - 1) / hdf5::chunk_rows;
        const std::int64_t nodes = chunks == 0 ? 0 : 1 + chunks / chunks_of_node;
        return chunks * hdf5::chunk_rows * 8 + nodes * node;
    };
    constexpr std::int64_t empty_file = 5912;
    return empty_file + 4 * dataset(events) + 5 * dataset(parts) + dataset(masses);
}

EventWriter::EventWriter(const partition::Communicator& comm, std::filesystem::path file, double dt, Worker* worker)
    : comm_{&comm}, file_{std::move(file)}, dt_{dt}, worker_{worker} {}

void EventWriter::append(std::span<const DupletEvent> events, const SplitParts& parts) const {
    std::vector<DupletEvent> all_events = comm_->gather(events);
    SplitParts all_parts = gather(*comm_, parts);
    std::function<void()> write = [this, all_events = std::move(all_events), all_parts = std::move(all_parts)] {
        append_on_root(sorted(all_events), io::sorted(all_parts));
    };
    if (worker_ == nullptr) {
        on_root(*comm_, write);
    } else if (comm_->is_root()) {
        worker_->post(std::move(write));
    }
}

void EventWriter::append_on_root(std::span<const DupletEvent> events, const SplitParts& parts) const {
    if (!std::filesystem::exists(file_)) {
        create_file(file_);
    }
    if (events.empty() && parts.size() == 0) {
        return;
    }
    reserve_space(file_, static_cast<std::int64_t>(std::filesystem::file_size(file_)) + bytes(events.size(), parts));
    hdf5::File file{file_, hdf5::Access::modify};
    append_events(file, events, dt_);
    append_parts(file, parts, dt_);
    file.close();
}

}  // namespace cracksim::io
