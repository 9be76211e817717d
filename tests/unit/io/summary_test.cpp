#include "io/summary.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

using Json = nlohmann::ordered_json;

TEST(Summary, HasTheKeysThatUsersRelyOn) {
    const Json json = Json::parse(summary_text({}));
    for (const char* pointer : {"/status",
                                "/bitwise",
                                "/provenance/version",
                                "/provenance/git",
                                "/provenance/compiler",
                                "/provenance/flags",
                                "/provenance/libraries",
                                "/provenance/cpu",
                                "/provenance/simd_target",
                                "/provenance/ranks",
                                "/provenance/host",
                                "/provenance/seed",
                                "/provenance/input_digest",
                                "/counts/entities",
                                "/counts/masses",
                                "/counts/interactions",
                                "/counts/duplets",
                                "/counts/unions",
                                "/counts/darts",
                                "/counts/interior_faces",
                                "/time/scheme",
                                "/time/precision",
                                "/time/step",
                                "/time/bound",
                                "/time/bound_cause",
                                "/time/steps",
                                "/time/end",
                                "/events/duplets",
                                "/events/splits",
                                "/event_hash",
                                "/state_hash",
                                "/fragments",
                                "/components",
                                "/crack_area",
                                "/energy/kinetic",
                                "/energy/elastic",
                                "/energy/dissipated",
                                "/energy/external",
                                "/energy/residual",
                                "/energy/scale",
                                "/momentum",
                                "/angular_momentum",
                                "/supports",
                                "/seconds/total",
                                "/seconds/setup",
                                "/seconds/force",
                                "/seconds/update",
                                "/seconds/sense",
                                "/seconds/exchange",
                                "/seconds/topology",
                                "/seconds/geometry",
                                "/seconds/output",
                                "/steps_per_second",
                                "/times_real_time",
                                "/memory/per_rank_max",
                                "/memory/per_entity",
                                "/memory/map_per_entity",
                                "/exchange/bytes_per_step",
                                "/exchange/neighbours_max",
                                "/exchange/waiting",
                                "/forecast/memory_intact",
                                "/forecast/memory_broken",
                                "/forecast/exchange_intact",
                                "/forecast/exchange_broken",
                                "/forecast/output_intact",
                                "/forecast/output_broken",
                                "/forecast/output_per_interface",
                                "/largest_fragments",
                                "/frames"}) {
        EXPECT_TRUE(json.contains(Json::json_pointer{pointer})) << pointer;
    }
    EXPECT_FALSE(json.contains("invalid"));
}

TEST(Summary, HashesAreSixteenHexDigits) {
    Summary summary;
    summary.event_hash = 0xabcULL;
    summary.state_hash = std::numeric_limits<std::uint64_t>::max();
    const Json json = Json::parse(summary_text(summary));
    EXPECT_EQ(json["event_hash"], "0000000000000abc");
    EXPECT_EQ(json["state_hash"], "ffffffffffffffff");
}

TEST(Summary, NumbersThatAreNotFiniteAreNull) {
    Summary summary;
    summary.energy.kinetic = std::numeric_limits<double>::quiet_NaN();
    summary.energy.elastic = std::numeric_limits<double>::infinity();
    const Json json = Json::parse(summary_text(summary));
    EXPECT_TRUE(json["energy"]["kinetic"].is_null());
    EXPECT_TRUE(json["energy"]["elastic"].is_null());
    EXPECT_EQ(json["energy"]["external"], 0.0);
}

TEST(Summary, InvalidRunNamesStepMassAndCause) {
    Summary summary;
    summary.status = Status::invalid;
    summary.invalid = {.step = 12, .mass = MassId{34}, .cause = "the step is above its bound"};
    const Json json = Json::parse(summary_text(summary));
    EXPECT_EQ(json["status"], "invalid");
    EXPECT_EQ(json["invalid"], (Json{{"step", 12}, {"mass", 34}, {"cause", "the step is above its bound"}}));
}

TEST(Summary, StoppedRunSaysWhy) {
    Summary summary;
    EXPECT_FALSE(Json::parse(summary_text(summary)).contains("error"));
    summary.status = Status::stopped;
    summary.error = "the disk is full";
    const Json json = Json::parse(summary_text(summary));
    EXPECT_EQ(json["status"], "stopped");
    EXPECT_EQ(json["error"], "the disk is full");
}

TEST(Summary, FramesAreListedBySeries) {
    Summary summary;
    summary.frames = {
        {"surface", {{.file = "frames/surface-000000.hdf", .step = 1, .time = 0.5, .faces = 6, .points = 8}}},
        {"crack", {}}};
    summary.largest_fragments = {{EntityId{5}, 0.25}};
    const Json json = Json::parse(summary_text(summary));
    EXPECT_EQ(json["frames"]["surface"][0]["faces"], 6);
    EXPECT_EQ(json["frames"]["surface"][0]["file"], "frames/surface-000000.hdf");
    EXPECT_TRUE(json["frames"]["crack"].is_array());
    EXPECT_EQ(json["largest_fragments"][0]["volume_share"], 0.25);
}

TEST(Summary, SupportsAreListedByName) {
    Summary summary;
    summary.momentum = {1, 2, 3};
    summary.supports = {{"left side", {4, 5, 6}, {7, 8, 9}, 10}};
    const Json json = Json::parse(summary_text(summary));
    EXPECT_EQ(json["momentum"], (Json{1.0, 2.0, 3.0}));
    EXPECT_EQ(json["supports"]["left side"]["force"], (Json{4.0, 5.0, 6.0}));
    EXPECT_EQ(json["supports"]["left side"]["displacement"], (Json{7.0, 8.0, 9.0}));
    EXPECT_EQ(json["supports"]["left side"]["work"], 10.0);
}

TEST(Summary, FileIsReplacedWhole) {
    const Scratch scratch;
    if (world().is_root()) {
        write_summary(scratch / "summary.json", {});
        write_summary(scratch / "summary.json", {});
        EXPECT_EQ(text_of(scratch / "summary.json"), summary_text({}));
        EXPECT_FALSE(has_unfinished(scratch.path()));
    }
}

TEST(Summary, SizeIsAboutKnownBeforehand) {
    Summary summary;
    const FrameRecord frame{"frames/surface-000001.hdf", 21, 1.0 / 3, 12600, 12602};
    summary.frames = {{"surface", std::vector(1000, frame)}};
    const auto size = static_cast<double>(summary_text(summary).size());
    EXPECT_NEAR(static_cast<double>(summary_bytes(1000)), size, 0.15 * size);
}

}  // namespace
}  // namespace cracksim::io
