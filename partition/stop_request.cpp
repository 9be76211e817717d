#include "partition/stop_request.hpp"

#include <csignal>

namespace cracksim::partition {

namespace {

volatile std::sig_atomic_t requested = 0;

void note(int /*signal*/) { requested = 1; }

}  // namespace

StopRequest::StopRequest() {
    requested = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGINT, &action, nullptr);
}

StopRequest::~StopRequest() {
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
}

bool StopRequest::is_made(const Communicator& comm) const { return comm.any(requested != 0); }

}  // namespace cracksim::partition
