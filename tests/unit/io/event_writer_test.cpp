#include "io/event_writer.hpp"

#include <gtest/gtest.h>

#include "io/hdf5.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

constexpr double dt = 0.001;

physics::DupletEvent event(std::int64_t step, std::int64_t a, std::int64_t b) { return {step, MassId{a}, MassId{b}}; }

/// Events and parts of the steps [from, to), in descending order of steps; rank s mod ranks has those of step s.
struct Happened {
    std::vector<physics::DupletEvent> events;
    SplitParts parts;
};
Happened happened(std::int64_t from, std::int64_t to) {
    Happened result;
    for (std::int64_t step = to - 1; step >= from; --step) {
        if (step % world().size() == world().rank().value()) {
            result.events.push_back(event(step, 20 + step, 30 + step));
            result.events.push_back(event(step, 10 + step, 30 + step));
            result.parts.add(step, MassId{step}, std::vector{MassId{50 + step}, MassId{51 + step}});
            result.parts.add(step, MassId{step}, std::vector{MassId{step}});
        }
    }
    return result;
}

using Integers = std::vector<std::int64_t>;

TEST(EventWriter, FirstCallMakesTheFileAlsoWithoutEvents) {
    const Scratch scratch;
    EventWriter{world(), scratch / "events.hdf", dt}.append({}, {});
    const hdf5::File file{scratch / "events.hdf", hdf5::Access::read};
    for (const char* name : {"/events/step", "/events/time", "/events/mass_a", "/events/mass_b", "/splits/step",
                             "/splits/time", "/splits/union", "/splits/first", "/splits/count", "/splits/masses"}) {
        EXPECT_EQ(file.rows(name), 0) << name;
    }
}

TEST(EventWriter, EventsStandInOrderOfStepAndDuplet) {
    const Scratch scratch;
    const Happened all = happened(0, 5);
    EventWriter{world(), scratch / "events.hdf", dt}.append(all.events, all.parts);
    const hdf5::File file{scratch / "events.hdf", hdf5::Access::read};
    EXPECT_EQ(file.read<std::int64_t>("/events/step"), (Integers{0, 0, 1, 1, 2, 2, 3, 3, 4, 4}));
    EXPECT_EQ(file.read<std::int64_t>("/events/mass_a"), (Integers{10, 20, 11, 21, 12, 22, 13, 23, 14, 24}));
    EXPECT_EQ(file.read<std::int64_t>("/events/mass_b"), (Integers{30, 30, 31, 31, 32, 32, 33, 33, 34, 34}));
    EXPECT_EQ(file.read<double>("/events/time")[9], 4 * dt);
}

TEST(EventWriter, PartsPointToTheirMasses) {
    const Scratch scratch;
    const Happened all = happened(0, 2);
    EventWriter{world(), scratch / "events.hdf", dt}.append(all.events, all.parts);
    const hdf5::File file{scratch / "events.hdf", hdf5::Access::read};
    EXPECT_EQ(file.read<std::int64_t>("/splits/step"), (Integers{0, 0, 1, 1}));
    EXPECT_EQ(file.read<std::int64_t>("/splits/union"), (Integers{0, 0, 1, 1}));
    EXPECT_EQ(file.read<std::int64_t>("/splits/first"), (Integers{0, 1, 3, 4}));
    EXPECT_EQ(file.read<std::int64_t>("/splits/count"), (Integers{1, 2, 1, 2}));
    EXPECT_EQ(file.read<std::int64_t>("/splits/masses"), (Integers{0, 50, 51, 1, 51, 52}));
    EXPECT_EQ(file.read<double>("/splits/time"), (std::vector<double>{0, 0, dt, dt}));
}

TEST(EventWriter, TwoGoesEqualOne) {
    const Scratch scratch;
    const Happened all = happened(0, 9);
    const Happened early = happened(0, 4);
    const Happened late = happened(4, 9);
    EventWriter{world(), scratch / "one.hdf", dt}.append(all.events, all.parts);
    const EventWriter two{world(), scratch / "two.hdf", dt};
    two.append(early.events, early.parts);
    two.append({}, {});
    two.append(late.events, late.parts);
    const hdf5::File a{scratch / "one.hdf", hdf5::Access::read};
    const hdf5::File b{scratch / "two.hdf", hdf5::Access::read};
    for (const char* name : {"/events/step", "/events/mass_a", "/events/mass_b", "/splits/step", "/splits/union",
                             "/splits/first", "/splits/count", "/splits/masses"}) {
        EXPECT_EQ(a.read<std::int64_t>(name), b.read<std::int64_t>(name)) << name;
        EXPECT_GT(a.rows(name), 0);
    }
    EXPECT_EQ(a.read<double>("/events/time"), b.read<double>("/events/time"));
    EXPECT_EQ(a.read<double>("/splits/time"), b.read<double>("/splits/time"));
    EXPECT_FALSE(has_unfinished(scratch.path()));
}

TEST(EventWriter, WhatAllRanksGiveIsWrittenOnce) {
    const Scratch scratch;
    SplitParts parts;
    parts.add(3, MassId{1}, std::vector{MassId{1}, MassId{9}});
    EventWriter{world(), scratch / "events.hdf", dt}.append(std::vector{event(3, 1, 2)}, parts);
    const hdf5::File file{scratch / "events.hdf", hdf5::Access::read};
    EXPECT_EQ(file.rows("/events/step"), 1);
    EXPECT_EQ(file.read<std::int64_t>("/splits/masses"), (Integers{1, 9}));
}

TEST(EventWriter, SizeOfTheFileIsKnownBeforehand) {
    for (const std::int64_t count : {0, 1, 4097, 300000}) {
        const Scratch scratch;
        std::vector<physics::DupletEvent> events;
        SplitParts parts;
        for (std::int64_t i = 0; i < count && world().is_root(); ++i) {
            events.push_back(event(i, i, i + 1));
            parts.add(i, MassId{i}, std::vector{MassId{i}, MassId{i + 1}});
        }
        EventWriter{world(), scratch / "events.hdf", dt}.append(events, parts);
        if (world().is_root()) {
            const auto size = static_cast<double>(std::filesystem::file_size(scratch / "events.hdf"));
            EXPECT_NEAR(static_cast<double>(event_file_bytes(count, count, 2 * count)), size, 0.03 * size) << count;
        }
    }
}

}  // namespace
}  // namespace cracksim::io
