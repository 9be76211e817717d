#include "io/file_error.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>

#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

TEST(FileErrorText, NamesOperationFileAndCause) {
    const FileError error = file_error("create", "a/b.txt", EACCES);
    EXPECT_STREQ(error.what(), "cannot create a/b.txt: Permission denied");
    EXPECT_FALSE(error.disk_full());
}

TEST(FileErrorText, FullDiskIsRecognised) {
    const FileError error = file_error("write", "a", ENOSPC);
    EXPECT_TRUE(error.disk_full());
    EXPECT_NE(std::string{error.what()}.find("the disk is full"), std::string::npos);
}

TEST(ReserveSpace, MoreThanTheDiskHasIsAFullDisk) {
    const Scratch scratch;
    if (!world().is_root()) {
        return;
    }
    touch(scratch / "file", "text");
    constexpr std::int64_t room_for_others = 1LL << 30;
    const auto free = static_cast<std::int64_t>(std::filesystem::space(scratch.path()).available);
    try {
        reserve_space(scratch / "file", free + room_for_others);
        FAIL() << "nothing thrown";
    } catch (const FileError& error) {
        EXPECT_TRUE(error.disk_full()) << error.what();
    }
    EXPECT_EQ(text_of(scratch / "file"), "text");
}

TEST(ReserveSpace, ContentStays) {
    const Scratch scratch;
    if (world().is_root()) {
        touch(scratch / "file", "text");
        EXPECT_NO_THROW(reserve_space(scratch / "file", 100000));
        EXPECT_TRUE(text_of(scratch / "file").starts_with("text"));
    }
}

}  // namespace
}  // namespace cracksim::io
