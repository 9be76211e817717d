#include "physics/state/listed_unions.hpp"

#include <limits>
#include <unordered_map>
#include <utility>

#include "core/hash.hpp"

namespace cracksim::physics {

ListedUnions::ListedUnions(const Unions& unions, std::vector<LocalMass> masses) : masses_{std::move(masses)} {
    std::unordered_map<VertexSite, std::uint32_t> last_at;
    for (std::uint32_t place = 0; place < masses_.size(); ++place) {
        const VertexSite v = unions.lattice().vertex(masses_[place]);
        vertex_.push_back(v);
        part_.push_back(static_cast<std::uint8_t>(unions.part(masses_[place])));
        const auto [last, is_first] = last_at.try_emplace(v, place);
        before_.push_back(is_first ? none : std::exchange(last->second, place));
    }
    find_entries();
}

std::vector<ListedUnions::NewPart> ListedUnions::update(const Unions& unions) {
    std::vector<NewPart> changed;
    for (std::uint32_t place = 0; place < masses_.size(); ++place) {
        const auto part = static_cast<std::uint8_t>(unions.part(masses_[place]));
        if (part != part_[place]) {
            part_[place] = part;
            changed.push_back({place, part});
        }
    }
    if (!changed.empty()) {
        find_entries();
    }
    return changed;
}

void ListedUnions::find_entries() {
    constexpr unsigned bits = 53;
    std::uint64_t parts = 0;
    for (const std::uint8_t part : part_) {
        parts = mix(parts + part);
    }
    fingerprint_ = parts >> (std::numeric_limits<std::uint64_t>::digits - bits);
    entries_.clear();
    for (std::uint32_t place = 0; place < masses_.size(); ++place) {
        if (!is_listed_before(place)) {
            entries_.push_back({local_union(vertex_[place], part_[place]), place});
        }
    }
}

bool ListedUnions::is_listed_before(std::size_t place) const {
    for (std::uint32_t other = before_[place]; other != none; other = before_[other]) {
        if (part_[other] == part_[place]) {
            return true;
        }
    }
    return false;
}

}  // namespace cracksim::physics
