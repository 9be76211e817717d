#include "topology/modify.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "topology/sew.hpp"

namespace cracksim::topology {
namespace {

/// The masses of one split with the part of each, in ascending order of masses.
class Parting {
public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void take(const physics::SplitStream& splits, std::size_t split) {
        part_of_.clear();
        for (std::size_t k = 0; k < splits.parts(split); ++k) {
            for (const LocalMass mass : splits.part(split, k)) {
                part_of_.emplace_back(mass, k);
            }
        }
        std::sort(part_of_.begin(), part_of_.end());
    }
    [[nodiscard]] std::size_t part(LocalMass mass) const {
        const auto at = std::lower_bound(part_of_.begin(), part_of_.end(), std::pair{mass, std::size_t{0}});
        return at == part_of_.end() || at->first != mass ? none : at->second;
    }
    [[nodiscard]] auto begin() const { return part_of_.begin(); }
    [[nodiscard]] auto end() const { return part_of_.end(); }

private:
    std::vector<std::pair<LocalMass, std::size_t>> part_of_;
};

UnsewnFace from_smaller_side(LocalEntity entity, int face, FaceLink other, double time) {
    if (other.entity() < entity) {
        return {other.entity(), other.face(), entity, face, time};
    }
    return {entity, face, other.entity(), other.face(), time};
}

void unsew_around(GMap& map, LocalMass corner, std::size_t part, const Parting& parting, double time,
                  Changes& changes) {
    const LocalEntity entity = entity_of(corner);
    for (const auto& [face, place] : Cell::faces_at(corner_of(corner))) {
        if (!map.leads_on(entity, face)) {
            continue;
        }
        const FaceLink other = map.link(entity, face);
        const std::size_t other_part = parting.part(corner_met(other, place));
        if (other_part != Parting::none && other_part != part) {
            unsew(map, entity, face);
            changes.unsewn.push_back(from_smaller_side(entity, face, other, time));
        }
    }
}

}  // namespace

Changes modify(GMap& map, const physics::SplitStream& splits) {
    Changes changes;
    Parting parting;
    for (std::size_t s = 0; s < splits.size(); ++s) {
        parting.take(splits, s);
        for (const auto& [corner, part] : parting) {
            unsew_around(map, corner, part, parting, splits.time(s), changes);
        }
    }
    return changes;
}

}  // namespace cracksim::topology
