#include "physics/simd_target.hpp"

#include <hwy/targets.h>

#include <algorithm>

namespace cracksim::physics {

namespace {

/// In Highway, better targets have lower bits. The lowest bit among the targets that are compiled in and supported by
/// the processor is the target in use.
std::int64_t target_in_use() {
    const std::int64_t usable = hwy::SupportedTargets() & HWY_TARGETS;
    return usable & -usable;
}

}  // namespace

std::vector<SimdTarget> simd_targets() {
    std::vector<SimdTarget> targets;
    for (std::int64_t left = HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        targets.push_back({hwy::TargetName(target), -target});
    }
    return targets;
}

std::optional<std::int64_t> simd_target_named(std::string_view name) {
    const std::vector<SimdTarget> targets = simd_targets();
    const auto found = std::ranges::find(targets, name, &SimdTarget::name);
    return found == targets.end() ? std::nullopt : std::optional{found->number};
}

std::int64_t best_simd_target() { return -target_in_use(); }

void limit_simd_target(std::int64_t target) { hwy::DisableTargets(-target - 1); }

std::string simd_target_name() { return hwy::TargetName(target_in_use()); }

}  // namespace cracksim::physics
