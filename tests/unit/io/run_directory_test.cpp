#include "io/run_directory.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "core/errors.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

namespace fs = std::filesystem;

/// The text of the InputError that check() throws; the same on all ranks.
std::string refusal(const fs::path& path) {
    try {
        RunDirectory{path}.check(world());
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

void on_root_then_all(const std::function<void()>& action) {
    if (world().is_root()) {
        action();
    }
    MPI_Barrier(world().handle());
}

TEST(RunDirectory, CheckTouchesNothing) {
    const Scratch scratch;
    EXPECT_EQ(refusal(scratch / "new.out"), "accepted");
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(RunDirectory, PrepareMakesADirectoryThatTheNextRunMayUse) {
    const Scratch scratch;
    const RunDirectory run{scratch / "new.out"};
    run.prepare(world());
    EXPECT_TRUE(fs::is_directory(run.file("frames")));
    EXPECT_EQ(refusal(run.path()), "accepted");
    EXPECT_NO_THROW(run.prepare(world()));
    EXPECT_FALSE(has_unfinished(run.path()));
}

TEST(RunDirectory, EmptyDirectoryIsUsedWhoeverMadeIt) {
    const Scratch scratch;
    EXPECT_EQ(refusal(scratch.path()), "accepted");
    EXPECT_EQ(refusal(scratch.path() / ""), "accepted");
    RunDirectory{scratch.path()}.prepare(world());
    EXPECT_TRUE(fs::exists(scratch / ".cracksim"));
}

TEST(RunDirectory, DirectoryOfSomeoneElseIsRefusedAndAdviceGiven) {
    const Scratch scratch;
    on_root_then_all([&] { touch(scratch / "thesis.tex"); });
    const std::string text = refusal(scratch.path());
    EXPECT_NE(text.find(scratch.path().string()), std::string::npos);
    EXPECT_NE(text.find("not empty and was not made by cracksim"), std::string::npos);
    EXPECT_NE(text.find("--out"), std::string::npos);
    EXPECT_THROW(RunDirectory{scratch.path()}.prepare(world()), InputError);
    EXPECT_FALSE(fs::exists(scratch / "frames"));
}

TEST(RunDirectory, PathsThatCannotBecomeADirectoryAreRefused) {
    const Scratch scratch;
    on_root_then_all([&] {
        touch(scratch / "file");
        fs::create_symlink("nowhere", scratch / "link");
    });
    EXPECT_NE(refusal(scratch / "file").find("it is a file"), std::string::npos);
    EXPECT_NE(refusal(scratch / "file/below").find("is not a directory"), std::string::npos);
    EXPECT_NE(refusal(scratch / "missing/below").find("does not exist"), std::string::npos);
    EXPECT_NE(refusal(scratch / "link").find("leads nowhere"), std::string::npos);
    EXPECT_NE(refusal("").find("empty"), std::string::npos);
}

TEST(RunDirectory, ALockedDirectoryIsRefusedAndKeepsItsFiles) {
    const Scratch scratch;
    const RunDirectory run{scratch / "run.out"};
    {
        const RunLock lock = run.prepare(world());
        on_root_then_all([&] { touch(run.file("summary.json")); });
        EXPECT_EQ(lock.held(), world().is_root());
        EXPECT_NE(refusal(run.path()).find("another run is writing"), std::string::npos);
        EXPECT_THROW(run.prepare(world()), InputError);
        EXPECT_TRUE(fs::exists(run.file("summary.json")));
        MPI_Barrier(world().handle());
    }
    EXPECT_NO_THROW(run.prepare(world()));
}

TEST(RunLock, WhereNothingCanBeLockedTheLockIsNotHeld) {
    const Scratch scratch;
    const auto lock = RunLock::take(scratch / "missing");
    ASSERT_TRUE(lock.has_value());
    EXPECT_FALSE(lock->held());
}

TEST(RunDirectory, OnlyFilesThatARunWritesAreRemoved) {
    const Scratch scratch;
    const RunDirectory run{scratch / "run.out"};
    run.prepare(world());
    const std::vector<std::string> ours{"summary.json",
                                        "history.csv",
                                        "events.hdf",
                                        "surface.xdmf",
                                        "crack.hdf.series",
                                        "input.resolved.yaml",
                                        "cracksim.log",
                                        "checkpoint.hdf",
                                        "checkpoint.previous.hdf",
                                        "summary.json.tmp",
                                        "frames/surface-000000.hdf",
                                        "frames/crack-1000000.hdf",
                                        "frames/masses-000003.hdf.tmp"};
    const std::vector<std::string> theirs{"notes.txt",
                                          "view.pvsm",
                                          "other.xdmf",
                                          "summary.json.bak",
                                          "mine.tmp",
                                          "frames/picture.png",
                                          "frames/surface-final.hdf",
                                          "frames/other-000000.hdf"};
    on_root_then_all([&] {
        for (const auto* files : {&ours, &theirs}) {
            for (const std::string& file : *files) {
                touch(run.file(file));
            }
        }
    });
    run.prepare(world());
    for (const std::string& file : ours) {
        EXPECT_FALSE(fs::exists(run.file(file))) << file;
    }
    for (const std::string& file : theirs) {
        EXPECT_TRUE(fs::exists(run.file(file))) << file;
    }
}

}  // namespace
}  // namespace cracksim::io
