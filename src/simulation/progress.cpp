#include "simulation/progress.hpp"

#include <array>
#include <cstdio>

#include "core/text.hpp"
#include "io/memory.hpp"

namespace cracksim::simulation {

namespace {

constexpr double seconds_between_plain_lines = 5.0;
constexpr double seconds_between_live_lines = 0.5;

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), format, values...);
    return line.data();
}

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

Progress::Progress(io::Log& log, ProgressStyle style) : log_{&log}, style_{style} {}

void Progress::heartbeat(const Simulation& simulation) {
    const auto now = Clock::now();
    const double interval = style_ == ProgressStyle::live ? seconds_between_live_lines : seconds_between_plain_lines;
    const partition::Communicator& comm = simulation.comm();
    if (!comm.any(comm.is_root() && seconds(now - last_) >= interval)) {
        return;
    }
    const Totals totals = simulation.totals();
    const auto memory = static_cast<double>(comm.sum(io::peak_resident_bytes()));
    const std::int64_t step = simulation.dynamics().state().step;
    const double rate = static_cast<double>(step - last_step_) / seconds(now - last_);
    const auto left = static_cast<double>(simulation.certified().steps - step);
    const std::string line =
        formatted("step %lld of %lld  t = %.4g s  %.0f steps/s  %.2f x real time  %lld splits  ",
                  static_cast<long long>(step), static_cast<long long>(simulation.certified().steps),
                  simulation.dynamics().state().time(), rate, rate * simulation.certified().step,
                  static_cast<long long>(totals.splits)) +
        bytes_text(memory) + "  " + duration_text(left / rate) + " left";
    style_ == ProgressStyle::live ? log_->live(line) : log_->info(line);
    last_ = now;
    last_step_ = step;
}

}  // namespace cracksim::simulation
