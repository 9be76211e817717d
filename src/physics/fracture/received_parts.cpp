#include "physics/fracture/received_parts.hpp"

#include <vector>

#include "core/sorted.hpp"

namespace cracksim::physics {

void set_received_parts(const Network& network, std::span<const ReceivedPart> parts, State& state, Engine& engine) {
    std::vector<VertexSite> vertices;
    std::vector<LocalUnion> left;
    for (const auto& [mass, part] : parts) {
        const LocalMass m = network.received()[mass];
        const LocalUnion before = state.unions.union_of(m);
        state.unions.set_received_part(m, part);
        state.motion.open(state.unions.union_of(m));
        state.motion.copy(before, state.unions.union_of(m));
        left.push_back(before);
        vertices.push_back(vertex_of(before));
    }
    for (const LocalUnion s : left) {
        if (state.unions.smallest_mass(s) == LocalMass{}) {
            state.motion.clear(s);
        }
    }
    if (!vertices.empty()) {
        sort_and_make_unique(vertices);
        engine.changed(state, vertices, vertices);
    }
}

void set_received_increments(const Network& network, std::span<const ReceivedIncrements> increments, State& state) {
    for (std::size_t i = 0; i < increments.size(); ++i) {
        const LocalUnion s = state.unions.union_of(network.received()[i]);
        state.set_increment(s, increments[i].increment);
        if (state.scheme == Scheme::ab2) {
            state.set_velocity_increment(s, increments[i].velocity_increment);
        }
    }
}

}  // namespace cracksim::physics
