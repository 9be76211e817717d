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

/// A union held by supports: for each component the support that prescribes it, -1 if the component is free.
struct HeldUnion {
    LocalUnion local_union;
    Vec3 rest;  ///< m
    std::array<std::int16_t, 3> support;
};

/// The touched unions that supports hold, and the work of the supports. Where two supports prescribe one component, the first
/// one in the scene does so (support_conflict refuses such scenes).
class HeldUnions {
public:
    HeldUnions(const Network& network, const Unions& unions);

    /// In the order in which they came to be.
    [[nodiscard]] const std::vector<HeldUnion>& all() const { return all_; }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    /// Null if supports do not hold the union.
    [[nodiscard]] const HeldUnion* find(LocalUnion s) const {
        const auto found = place_.find(s);
        return found == place_.end() ? nullptr : &all_[found->second];
    }
    /// A held union has split: each part is held. The first part takes the place of the whole union.
    void split(LocalUnion whole, std::span<const LocalUnion> parts);
    [[nodiscard]] std::size_t memory_bytes() const { return all_.capacity() * sizeof(HeldUnion); }

    double work{0};  ///< J, of the supports on the unions that this rank owns, since step 0

private:
    void add(const HeldUnion& held);

    std::vector<HeldUnion> all_;
    std::unordered_map<LocalUnion, std::size_t> place_;
};

}  // namespace cracksim::physics
