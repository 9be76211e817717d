#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/vec3.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/motion.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// A union that supports hold. For each component: the support that prescribes it, -1 if the component is free.
struct HeldUnion {
    LocalUnion local_union;
    Vec3 rest;  ///< m
    std::array<std::int16_t, 3> support;
};

/// The components of a union at `rest` that the supports prescribe.
[[nodiscard]] HeldUnion held_at(const Network& network, LocalUnion s, Vec3 rest);

/// The touched unions that supports hold, and the work of the supports. If two supports prescribe the same component,
/// the first one in the scene counts; support_conflict() detects such scenes, and a run refuses them.
class HeldUnions {
public:
    HeldUnions(const Network& network, const Unions& unions);

    /// In the order in which they were added.
    [[nodiscard]] const std::vector<HeldUnion>& all() const { return all_; }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    /// Null if supports do not hold the union.
    [[nodiscard]] const HeldUnion* find(LocalUnion s) const {
        const auto found = place_.find(s);
        return found == place_.end() ? nullptr : &all_[found->second];
    }
    /// Replaces a held union that has split by its parts, which are all held. The first part takes the place of the
    /// whole union.
    void split(LocalUnion whole, std::span<const LocalUnion> parts);
    [[nodiscard]] std::size_t memory_bytes() const { return all_.capacity() * sizeof(HeldUnion); }

    /// Adds force times path of the held components of a union to the work of their supports.
    void add_work(const HeldUnion& held, Vec3 force, Vec3 path);
    /// By support: its work on the unions that this rank owns, from half a step before step 0 to half a step before the
    /// current step, J.
    [[nodiscard]] const std::vector<double>& work() const { return work_; }

private:
    void add(const HeldUnion& held);

    std::vector<double> work_;
    std::vector<HeldUnion> all_;
    std::unordered_map<LocalUnion, std::size_t> place_;
};

}  // namespace cracksim::physics
