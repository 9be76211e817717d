#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/lattice/caches.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

/// The prefilter of the `normal` sensors on the lattice: it looks only where the sweep found an edge stretched enough. It is exact:
/// |PQ| <= l1 + l2, so no sensor triggers while l1 + l2 <= (1 + s) R0 (sensing_limits.hpp).
///
/// An edge mostly stays stretched for many steps, and to look up the sensors over it costs more than all else: they are kept until one
/// of the edge's vertices changes.
class StretchedSensors {
public:
    explicit StretchedSensors(const Lattice& lattice) : revision_(lattice.vertex_sites(), 0) {}

    /// What is kept at most for an interior face of a network whose edges are all stretched: both edges under a sensor know it.
    [[nodiscard]] static constexpr std::size_t bytes_per_face() { return duplets_per_face * 2 * sizeof(SensorOver); }
    /// What is kept for a vertex.
    [[nodiscard]] static constexpr std::size_t bytes_per_vertex() { return sizeof(Revision); }

    /// Sensors over edges at these vertices, or the masses that they watch, changed.
    void forget(std::span<const VertexSite> vertices);
    /// The active duplets whose sensors may trigger at the state of the last sweep, some of them twice.
    [[nodiscard]] std::vector<LocalDuplet> find(const Network& network, const State& state,
                                                const LatticeCaches& caches);
    [[nodiscard]] std::size_t memory_bytes() const { return revision_.capacity() * sizeof(Revision); }

private:
    /// Counts the changes at a vertex: at most twelve, as each takes one of its duplets.
    using Revision = std::uint8_t;
    /// A sensor that reaches over a stretched edge from its near end, and on over another edge in line with it to a far mass.
    struct SensorOver {
        LocalUnion near;
        LocalMass far;
        VertexSite far_vertex;
        LocalDuplet duplet;
        float limit;  ///< |D|^2/R0^2 - 1 up to which it cannot trigger
        std::uint8_t axis;
        bool goes_up;  ///< from near to far
    };
    /// An edge stretched beyond its limit, and how many sensors reach over it.
    struct StretchedEdge {
        std::int64_t place;  ///< ascends from edge to edge
        std::array<VertexSite, 2> vertex;
        std::int16_t revision;  ///< of both vertices, together, when all this was looked up
        std::int16_t sensors;
    };
    /// All of a step.
    struct StretchedEdges {
        std::vector<StretchedEdge> edges;
        std::vector<SensorOver> sensors;  ///< edge after edge

        /// Forgets them; of the room, keeps about as much as those of the step before take.
        void clear(const StretchedEdges& before);
    };

    [[nodiscard]] std::int16_t revision(const std::array<VertexSite, 2>& vertex) const {
        return static_cast<std::int16_t>(revision_[vertex[0].index()] + revision_[vertex[1].index()]);
    }
    void find_stretched(const Network& network, const State& state, const LatticeCaches& caches);
    void look_up(const Network& network, const State& state, Site site, int edge);

    std::vector<Revision> revision_;
    StretchedEdges now_;
    StretchedEdges before_;
};

}  // namespace cracksim::physics
