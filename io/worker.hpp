#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace cracksim::io {

/// A thread for what takes time with files while the run goes on: jobs one after the other. It starts with the first job;
/// that it cannot be started counts as a job's failure. Only one thread posts, waits and asks.
/// Jobs must not communicate: only the main thread may use MPI. HDF5 knows no threads: whoever uses it elsewhere calls
/// wait() before. After a job has failed the others are dropped, until somebody has been told by check() or wait().
class Worker {
public:
    Worker() = default;
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    /// Drops what has not begun.
    ~Worker();

    /// Waits while too many jobs do: they hold what they write.
    void post(std::function<void()> job);
    /// Until all is done. Throws what a job threw.
    void wait();
    /// Until all is done; what a job threw is still to be told.
    void settle();
    /// Throws what a job threw.
    void check();

private:
    void start();
    void work();

    static constexpr std::size_t most_waiting = 1;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::function<void()>> jobs_;
    bool working_{false};
    bool ending_{false};
    std::exception_ptr failure_;
    std::thread thread_;
};

}  // namespace cracksim::io
