#include "io/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/errors.hpp"
#include "io/input_text.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& path) {
    try {
        static_cast<void>(read_input_file(path));
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string refused(const fs::path& path, const std::string& why) {
    return path.string() + ": " + why + "; name a scene's file, such as inputs/block.yaml";
}

class InputFile : public ::testing::Test {
protected:
    /// The path of a file for this rank alone: here all ranks read, while in a run only the root reads.
    fs::path own(const std::string& name) const { return scratch_ / (name + std::to_string(world().rank().value())); }

    Scratch scratch_;
};

TEST_F(InputFile, IsReadByteForByte) {
    const std::string bytes{"a: 1\r\n\0\xff", 8};
    std::ofstream{own("file"), std::ios::binary} << bytes;
    EXPECT_EQ(read_input_file(own("file")), bytes);
}

TEST_F(InputFile, IsReadNoFurtherThanASceneMayReach) {
    std::ofstream{own("large")};
    fs::resize_file(own("large"), std::uintmax_t{1} << 40U);
    EXPECT_EQ(read_input_file(own("large")).size(), largest_input + 1);
}

TEST_F(InputFile, OnlyFilesAreOpened) {
    ASSERT_EQ(mkfifo(own("pipe").c_str(), 0600), 0);
    const std::string no_file = "is a device, a pipe or a socket, not a file";
    EXPECT_EQ(refusal(own("pipe")), refused(own("pipe"), no_file));
    EXPECT_EQ(refusal("/dev/zero"), refused("/dev/zero", no_file));
    EXPECT_EQ(refusal(scratch_.path()), refused(scratch_.path(), "is a directory"));
}

TEST_F(InputFile, TellsWhyItCannotBeRead) {
    EXPECT_EQ(refusal(own("absent")), refused(own("absent"), "cannot be opened: No such file or directory"));
    EXPECT_EQ(refusal("/proc/self/mem"), refused("/proc/self/mem", "cannot be read: Input/output error"));
}

}  // namespace
}  // namespace cracksim::io
