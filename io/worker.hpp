#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace cracksim::io {

/// A thread that does file work while the run goes on, one job after the other. It starts with the first job; if it
/// cannot be started, this counts as a failed job. Only one thread may call post(), wait(), settle() and check().
/// Jobs must not communicate: only the main thread may use MPI. HDF5 is not thread-safe: another thread must call
/// wait() before it uses HDF5. After a job has failed, other jobs are dropped until check() or wait() has thrown the
/// failure.
class Worker {
public:
    Worker() = default;
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    /// Drops the jobs that have not begun.
    ~Worker();

    /// Adds a job. Waits while too many jobs wait, because each job holds the data that it writes.
    void post(std::function<void()> job);
    /// Waits until all jobs are done. Throws the exception of a failed job.
    void wait();
    /// Waits until all jobs are done. Does not throw; the exception of a failed job is kept.
    void settle();
    /// Throws the exception of a failed job.
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
