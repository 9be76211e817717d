#include "io/worker.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

namespace cracksim::io {
namespace {

TEST(Worker, DoesJobsInTheirOrderAndWaitIsAfterTheLast) {
    Worker worker;
    std::vector<int> done;
    for (int i = 0; i < 50; ++i) {
        worker.post([&done, i] { done.push_back(i); });
    }
    worker.wait();
    ASSERT_EQ(done.size(), 50U);
    for (int i = 0; i < 50; ++i) {
        EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    }
}

TEST(Worker, RunsBesideTheThreadThatPosts) {
    Worker worker;
    std::thread::id thread;
    worker.post([&] { thread = std::this_thread::get_id(); });
    worker.wait();
    EXPECT_NE(thread, std::this_thread::get_id());
    EXPECT_NE(thread, std::thread::id{});
}

TEST(Worker, TellsWhatAJobThrewOnceAndDropsTheJobsBehindIt) {
    Worker worker;
    int done = 0;
    worker.post([] { throw std::runtime_error{"no room"}; });
    EXPECT_THROW(worker.wait(), std::runtime_error);
    EXPECT_NO_THROW(worker.wait());
    worker.post([&] { ++done; });
    worker.wait();
    EXPECT_EQ(done, 1);
}

TEST(Worker, DropsTheJobsBehindOneThatFailedUntilThatIsTold) {
    Worker worker;
    int done = 0;
    worker.post([] { throw std::runtime_error{"no room"}; });
    worker.settle();
    worker.post([&] { ++done; });
    EXPECT_THROW(worker.wait(), std::runtime_error);
    EXPECT_EQ(done, 0);
}

TEST(Worker, IsNotMetBySignals) {
    Worker worker;
    sigset_t blocked;
    worker.post([&] { pthread_sigmask(SIG_SETMASK, nullptr, &blocked); });
    worker.wait();
    EXPECT_EQ(sigismember(&blocked, SIGTERM), 1);
    EXPECT_EQ(sigismember(&blocked, SIGINT), 1);
}

TEST(Worker, SettlesWithoutTellingWhatAJobThrew) {
    Worker worker;
    worker.post([] { throw std::runtime_error{"no room"}; });
    EXPECT_NO_THROW(worker.settle());
    EXPECT_THROW(worker.check(), std::runtime_error);
}

TEST(Worker, DropsWhatHasNotBegunWhenItEnds) {
    int done = 0;
    {
        Worker worker;
        worker.post([&] { ++done; });
    }
    EXPECT_LE(done, 1);
}

TEST(Worker, WithoutJobsHasNothingToTell) {
    Worker worker;
    EXPECT_NO_THROW(worker.check());
    EXPECT_NO_THROW(worker.wait());
}

}  // namespace
}  // namespace cracksim::io
