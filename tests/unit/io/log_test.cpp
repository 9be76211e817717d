#include "io/log.hpp"

#include <gtest/gtest.h>

#include "io/file_error.hpp"
#include "unit/io/scratch.hpp"

namespace cracksim::io {
namespace {

struct Terminal {
    std::string out;
    std::string problems;
};

template <class Action>
Terminal captured(bool quiet, Action action) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    {
        Log log{world(), quiet};
        action(log);
    }
    return {testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

std::string of_root(const std::string& text) { return world().is_root() ? text : ""; }

TEST(Log, PlainLinesGoToStdoutAndProblemsToStderr) {
    const Terminal seen = captured(false, [](Log& log) {
        log.info("step 1");
        log.warn("thin plate");
        log.error("no room");
    });
    EXPECT_EQ(seen.out, of_root("step 1\n"));
    EXPECT_EQ(seen.problems, of_root("warning: thin plate\nerror: no room\n"));
}

TEST(Log, QuietLeavesProblemsOnly) {
    const Terminal seen = captured(true, [](Log& log) {
        log.info("step 1");
        log.live("50 %");
        log.warn("thin plate");
    });
    EXPECT_EQ(seen.out, "");
    EXPECT_EQ(seen.problems, of_root("warning: thin plate\n"));
}

TEST(Log, FileHoldsAllLinesSinceItWasOpenedAlsoWhenQuiet) {
    const Scratch scratch;
    captured(true, [&](Log& log) {
        log.info("before");
        log.open(scratch / "cracksim.log");
        log.info("step 1");
        log.warn("thin plate");
        log.live("50 %");
    });
    MPI_Barrier(world().handle());
    const std::string text = text_of(scratch / "cracksim.log");
    EXPECT_EQ(text.find("before"), std::string::npos);
    EXPECT_NE(text.find(" info: step 1\n"), std::string::npos);
    EXPECT_NE(text.find(" warning: thin plate\n"), std::string::npos);
    EXPECT_EQ(text.find("50 %"), std::string::npos);
}

TEST(Log, BracesInTextStayAsTheyAre) {
    EXPECT_EQ(captured(false, [](Log& log) { log.info("support {left} {0}"); }).out, of_root("support {left} {0}\n"));
}

TEST(Log, LiveLineIsRedrawnAndWiped) {
    const Terminal seen = captured(false, [](Log& log) {
        log.live("100 %");
        log.live("5 %");
        log.info("end");
    });
    EXPECT_EQ(seen.out, of_root("\r100 %\r5 %  \r   \rend\n"));
}

TEST(Log, FileThatCannotBeMadeIsThrownOnAllRanks) {
    captured(true, [](Log& log) { EXPECT_THROW(log.open("/dev/null/cracksim.log"), FileError); });
}

}  // namespace
}  // namespace cracksim::io
