#include "io/worker.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

namespace cracksim::io {
namespace {

TEST(Background, DoesJobsInTheirOrderAndWaitIsAfterTheLast) {
    Background background;
    std::vector<int> done;
    for (int i = 0; i < 50; ++i) {
        background.post([&done, i] { done.push_back(i); });
    }
    background.wait();
    ASSERT_EQ(done.size(), 50U);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    }
}

TEST(Background, RunsBesideTheThreadThatPosts) {
    Background background;
    std::thread::id worker;
    background.post([&] { worker = std::this_thread::get_id(); });
    background.wait();
    EXPECT_NE(worker, std::this_thread::get_id());
    EXPECT_NE(worker, std::thread::id{});
}

TEST(Background, TellsWhatAJobThrewOnceAndDropsTheJobsBehindIt) {
    Background background;
    int done = 0;
    background.post([] { throw std::runtime_error{"no room"}; });
    EXPECT_THROW(background.wait(), std::runtime_error);
    EXPECT_NO_THROW(background.wait());
    background.post([&] { ++done; });
    background.wait();
    EXPECT_EQ(done, 1);
}

TEST(Background, DropsTheJobsBehindOneThatFailedUntilThatIsTold) {
    Background background;
    int done = 0;
    background.post([] { throw std::runtime_error{"no room"}; });
    background.settle();
    background.post([&] { ++done; });
    EXPECT_THROW(background.wait(), std::runtime_error);
    EXPECT_EQ(done, 0);
}

TEST(Background, IsNotMetBySignals) {
    Background background;
    sigset_t blocked;
    background.post([&] { pthread_sigmask(SIG_SETMASK, nullptr, &blocked); });
    background.wait();
    EXPECT_EQ(sigismember(&blocked, SIGTERM), 1);
    EXPECT_EQ(sigismember(&blocked, SIGINT), 1);
}

TEST(Background, SettlesWithoutTellingWhatAJobThrew) {
    Background background;
    background.post([] { throw std::runtime_error{"no room"}; });
    EXPECT_NO_THROW(background.settle());
    EXPECT_THROW(background.check(), std::runtime_error);
}

TEST(Background, DropsWhatHasNotBegunWhenItEnds) {
    int done = 0;
    {
        Background background;
        background.post([&] { ++done; });
    }
    EXPECT_LE(done, 1);
}

TEST(Background, WithoutJobsHasNothingToTell) {
    Background background;
    EXPECT_NO_THROW(background.check());
    EXPECT_NO_THROW(background.wait());
}

}  // namespace
}  // namespace cracksim::io
