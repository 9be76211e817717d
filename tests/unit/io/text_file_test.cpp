#include "io/text_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

TEST(WriteText, ReplacesAFileAndLeavesNoOther) {
    const Scratch scratch;
    if (world().is_root()) {
        write_text(scratch / "file", "old and long");
        write_text(scratch / "file", "new");
        EXPECT_EQ(text_of(scratch / "file"), "new");
        EXPECT_FALSE(has_unfinished(scratch.path()));
    }
}

TEST(WriteText, FullDiskLeavesTheOldFileWhole) {
    const Scratch scratch;
    if (world().is_root()) {
        write_text(scratch / "file", "old");
        std::filesystem::create_symlink("/dev/full", scratch / "file.tmp");
        try {
            write_text(scratch / "file", "new");
            ADD_FAILURE() << "nothing thrown";
        } catch (const FileError& error) {
            EXPECT_TRUE(error.disk_full()) << error.what();
        }
        EXPECT_EQ(text_of(scratch / "file"), "old");
        EXPECT_FALSE(has_unfinished(scratch.path()));
    }
}

TEST(WriteText, MissingDirectoryIsNamed) {
    try {
        write_text("/nowhere/file", "text");
        FAIL() << "nothing thrown";
    } catch (const FileError& error) {
        EXPECT_STREQ(error.what(), "cannot create /nowhere/file.tmp: No such file or directory");
    }
}

TEST(Exact, EveryDoubleReadsBackToItsBits) {
    for (const double value : {0.1, 1.0 / 3, 1e300, std::numeric_limits<double>::epsilon()}) {
        EXPECT_EQ(std::stod(exact(value)), value);
    }
    EXPECT_EQ(exact(0.02), "0.02");
}

}  // namespace
}  // namespace cracksim::io
