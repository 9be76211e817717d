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

/// The prefilter of the `normal` sensors on the lattice. It considers only sensors over edges that the sweep found
/// stretched beyond their limits. It is exact: |PQ| <= l1 + l2, so no sensor triggers while l1 + l2 <= (1 + s) R0
/// (sensing_limits.hpp).
///
/// An edge usually stays stretched for many steps, and finding the sensors over it is the most expensive part. So these
/// sensors are kept until one of the edge's vertices changes.
class StretchedSensors {
public:
    explicit StretchedSensors(const Lattice& lattice) : revision_(lattice.vertex_sites(), 0) {}

    /// The largest memory per interior face, if all edges are stretched: each sensor is kept for both edges under it.
    [[nodiscard]] static constexpr std::size_t bytes_per_face() { return duplets_per_face * 2 * sizeof(SensorOver); }
    /// Memory per vertex site.
    [[nodiscard]] static constexpr std::size_t bytes_per_vertex() { return sizeof(Revision); }

    /// Discards the sensors that are kept for edges at these vertices, because duplets or parts changed there.
    void forget(std::span<const VertexSite> vertices);
    /// The active duplets whose sensors may trigger at the state of the last sweep; a duplet may occur twice.
    [[nodiscard]] std::vector<LocalDuplet> find(const Network& network, const State& state,
                                                const LatticeCaches& caches);
    [[nodiscard]] std::size_t memory_bytes() const { return revision_.capacity() * sizeof(Revision); }

private:
    /// Counts the changes at a vertex: at most twelve, because each change inactivates at least one of its duplets.
    using Revision = std::uint8_t;
    /// A sensor over a stretched edge. It reaches from the edge's near end over the edge, and over another edge in line
    /// with it to the far mass.
    struct SensorOver {
        LocalUnion near;
        LocalMass far;
        VertexSite far_vertex;
        LocalDuplet duplet;
        float limit;  ///< |D|^2/R0^2 - 1 up to which it cannot trigger
        std::uint8_t axis;
        bool goes_up;  ///< from near to far
    };
    /// An edge stretched beyond its limit, and the number of sensors that reach over it.
    struct StretchedEdge {
        std::int64_t place;  ///< ascends from edge to edge
        std::array<VertexSite, 2> vertex;
        std::int16_t revision;  ///< sum of both vertices' revisions when the sensors were found
        std::int16_t sensors;
    };
    /// The stretched edges of a step.
    struct StretchedEdges {
        std::vector<StretchedEdge> edges;
        std::vector<SensorOver> sensors;  ///< edge after edge

        /// Removes all edges. Keeps about as much capacity as the edges of the previous step need.
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
