#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/machine_limits.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "tests/bench/machine_limits.hpp"

HWY_BEFORE_NAMESPACE();
namespace cracksim::test::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Twelve chains of FMA hide a latency of up to six cycles at two FMA a cycle and leave registers for the factors.
template <class T>
HWY_INLINE T MultiplyAdd(std::size_t rounds) {
    const hn::ScalableTag<T> d;
    const auto a = hn::Set(d, static_cast<T>(0.999));
    const auto b = hn::Set(d, static_cast<T>(1e-3));
    // The chains start from different values; the compiler would merge equal chains.
    const auto start = [&](int chain) { return hn::Set(d, static_cast<T>(chain)); };
    auto x0 = start(0), x1 = start(1), x2 = start(2), x3 = start(3), x4 = start(4), x5 = start(5);
    auto x6 = start(6), x7 = start(7), x8 = start(8), x9 = start(9), x10 = start(10), x11 = start(11);
    for (std::size_t i = 0; i < rounds; ++i) {
        x0 = hn::MulAdd(x0, a, b);
        x1 = hn::MulAdd(x1, a, b);
        x2 = hn::MulAdd(x2, a, b);
        x3 = hn::MulAdd(x3, a, b);
        x4 = hn::MulAdd(x4, a, b);
        x5 = hn::MulAdd(x5, a, b);
        x6 = hn::MulAdd(x6, a, b);
        x7 = hn::MulAdd(x7, a, b);
        x8 = hn::MulAdd(x8, a, b);
        x9 = hn::MulAdd(x9, a, b);
        x10 = hn::MulAdd(x10, a, b);
        x11 = hn::MulAdd(x11, a, b);
    }
    const auto sum =
        hn::Add(hn::Add(hn::Add(x0, x1), hn::Add(x2, x3)),
                hn::Add(hn::Add(hn::Add(x4, x5), hn::Add(x6, x7)), hn::Add(hn::Add(x8, x9), hn::Add(x10, x11))));
    return hn::GetLane(hn::SumOfLanes(d, sum));
}

double MultiplyAddDouble(std::size_t rounds) { return MultiplyAdd<double>(rounds); }
float MultiplyAddSingle(std::size_t rounds) { return MultiplyAdd<float>(rounds); }

/// The flops of a round of MultiplyAdd.
std::size_t FlopsOfRound(bool single) {
    constexpr std::size_t chains = 12;
    return 2 * chains * (single ? hn::Lanes(hn::ScalableTag<float>{}) : hn::Lanes(hn::ScalableTag<double>{}));
}

void Triad(double* a, const double* b, const double* c, std::size_t count) {
    const hn::ScalableTag<double> d;
    const auto s = hn::Set(d, 3.0);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        hn::Store(hn::MulAdd(s, hn::Load(d, c + i), hn::Load(d, b + i)), d, a + i);
    }
}

}  // namespace cracksim::test::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <hwy/aligned_allocator.h>
#include <hwy/targets.h>

#include <algorithm>
#include <chrono>
#include <fstream>

namespace cracksim::test {

HWY_EXPORT(MultiplyAddDouble);
HWY_EXPORT(MultiplyAddSingle);
HWY_EXPORT(FlopsOfRound);
HWY_EXPORT(Triad);

namespace {

using Clock = std::chrono::steady_clock;

template <class Action>
double best_seconds(int attempts, Action&& action) {
    double best = 1e9;
    for (int i = 0; i < attempts; ++i) {
        const auto start = Clock::now();
        action();
        best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
    }
    return best;
}

double gigaflops(bool single) {
    constexpr std::size_t rounds = 1'000'000;
    // Volatile, so that the compiler does not remove the computation of the sums.
    volatile double sink = 0;
    const double seconds = best_seconds(15, [&] {
        sink = single ? static_cast<double>(HWY_DYNAMIC_DISPATCH(MultiplyAddSingle)(rounds))
                      : HWY_DYNAMIC_DISPATCH(MultiplyAddDouble)(rounds);
    });
    return static_cast<double>(HWY_DYNAMIC_DISPATCH(FlopsOfRound)(single) * rounds) / seconds * 1e-9;
}

double triad_gigabytes(std::size_t bytes) {
    constexpr std::size_t whole_vectors = 64;
    const std::size_t count = bytes / (3 * sizeof(double)) / whole_vectors * whole_vectors;
    const auto a = hwy::AllocateAligned<double>(count);
    const auto b = hwy::AllocateAligned<double>(count);
    const auto c = hwy::AllocateAligned<double>(count);
    std::fill_n(a.get(), count, 0.0);
    std::fill_n(b.get(), count, 1.0);
    std::fill_n(c.get(), count, 2.0);
    const std::size_t sweeps = std::max<std::size_t>(1, (std::size_t{1} << 26) / bytes);
    const double seconds = best_seconds(9, [&] {
        for (std::size_t i = 0; i < sweeps; ++i) {
            HWY_DYNAMIC_DISPATCH(Triad)(a.get(), b.get(), c.get(), count);
        }
    });
    return static_cast<double>(3 * sizeof(double) * count * sweeps) / seconds * 1e-9;
}

/// The size of the first core's data cache of a level, as Linux reports it; otherwise the guess.
std::size_t cache_bytes(int level, std::size_t guess) {
    for (int index = 0; index < 5; ++index) {
        const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
        int found = 0;
        std::string type;
        std::size_t kibibytes = 0;
        std::ifstream{folder + "level"} >> found;
        std::ifstream{folder + "type"} >> type;
        std::ifstream{folder + "size"} >> kibibytes;
        if (found == level && type != "Instruction" && kibibytes > 0) {
            return kibibytes * 1024;
        }
    }
    return guess;
}

}  // namespace

const MachineLimits::Triad& MachineLimits::triad_of(std::size_t bytes) const {
    const auto found = std::ranges::find_if(triads, [&](const Triad& t) { return 2 * t.bytes >= bytes; });
    return found == triads.end() ? triads.back() : *found;
}

MachineLimits measure_limits() {
    const std::size_t l1 = cache_bytes(1, 32U << 10U);
    const std::size_t l2 = cache_bytes(2, 1U << 20U);
    const std::size_t l3 = cache_bytes(3, 32U << 20U);
    // Half of a cache certainly belongs to this core alone; a shared L3 may be larger than this core's part of it.
    const std::size_t memory = std::min(std::max<std::size_t>(4 * l3, std::size_t{1} << 28), std::size_t{1} << 30);
    MachineLimits limits{
        gigaflops(false), gigaflops(true), {{"L1", l1 / 2}, {"L2", l2 / 2}, {"L3", l3 / 2}, {"memory", memory}}};
    for (auto& triad : limits.triads) {
        triad.gigabytes = triad_gigabytes(triad.bytes);
    }
    return limits;
}

std::string vector_name() {
    const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
    return hwy::TargetName(usable & -usable);
}

}  // namespace cracksim::test

#endif
