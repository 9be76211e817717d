#include "physics/state/parts.hpp"

#include <algorithm>
#include <numeric>

namespace cracksim::physics {

namespace {

/// The mass that an active duplet across a face ties to this mass, or none.
LocalMass tied_over(const Network& network, const DupletSet& active, LocalMass m, int face) {
    const auto tie = network.tie_over(m, face);
    return tie && active.contains(tie->duplet) ? tie->mass : LocalMass{};
}

}  // namespace

std::vector<std::vector<LocalMass>> connected_parts(const Network& network, const DupletSet& active,
                                                    std::span<const LocalMass> masses) {
    std::vector<std::size_t> component(masses.size());
    std::iota(component.begin(), component.end(), std::size_t{0});
    for (std::size_t i = 0; i < masses.size(); ++i) {
        for (int face = 0; face < Hexahedron::faces; ++face) {
            const auto other = std::ranges::find(masses, tied_over(network, active, masses[i], face));
            if (other != masses.end()) {
                const std::size_t a = component[i];
                const std::size_t b = component[static_cast<std::size_t>(other - masses.begin())];
                std::ranges::replace(component, std::max(a, b), std::min(a, b));
            }
        }
    }
    std::vector<std::vector<LocalMass>> parts;
    for (std::size_t first = 0; first < masses.size(); ++first) {
        if (component[first] != first) {
            continue;
        }
        parts.emplace_back();
        for (std::size_t i = first; i < masses.size(); ++i) {
            if (component[i] == first) {
                parts.back().push_back(masses[i]);
            }
        }
    }
    return parts;
}

}  // namespace cracksim::physics
