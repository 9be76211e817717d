#include "io/worker.hpp"

#include <csignal>
#include <utility>

#include "io/hdf5.hpp"

namespace cracksim::io {

namespace {

/// A signal in this thread would interrupt its system calls.
void leave_signals_to_others() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

Worker::~Worker() {
    {
        const std::scoped_lock lock{mutex_};
        ending_ = true;
        jobs_.clear();
    }
    changed_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void Worker::post(std::function<void()> job) {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return jobs_.size() < most_waiting; });
    if (failure_) {
        return;
    }
    try {
        start();
        jobs_.push_back(std::move(job));
    } catch (...) {
        failure_ = std::current_exception();
    }
    changed_.notify_all();
}

void Worker::start() {
    if (!thread_.joinable()) {
        hdf5::start();
        thread_ = std::thread{[this] { work(); }};
    }
}

void Worker::settle() {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return jobs_.empty() && !working_; });
}

void Worker::wait() {
    settle();
    check();
}

void Worker::check() {
    const std::scoped_lock lock{mutex_};
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

void Worker::work() {
    leave_signals_to_others();
    std::unique_lock lock{mutex_};
    for (;;) {
        changed_.wait(lock, [&] { return ending_ || !jobs_.empty(); });
        if (ending_) {
            return;
        }
        const std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        working_ = true;
        lock.unlock();
        std::exception_ptr failure;
        try {
            job();
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        working_ = false;
        if (failure) {
            failure_ = failure;
            jobs_.clear();
        }
        changed_.notify_all();
    }
}

}  // namespace cracksim::io
