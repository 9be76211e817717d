#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/lattice/shared_edges.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"

namespace cracksim::physics {

enum class Prefilter { on, off };

/// Finds, step by step, the duplets whose `normal` sensor triggers. The sensor of a duplet A|B measures the distance between the masses
/// P of A's entity and Q of B's that lie one edge off the shared face (rest distance R0), and triggers when its stretch exceeds the
/// threshold: ((2 D0 + dU).dU)/(|D| + R0) > s R0.
///
/// The prefilter looks only where the force sweep found an edge stretched enough. It is exact: |PQ| <= l1 + l2, so no sensor
/// triggers while l1 + l2 <= (1 + s) R0; a margin of 1e-12, in single precision 4e-6, covers rounding. All sensors that trigger act together.
class Sensors {
public:
    explicit Sensors(Prefilter prefilter) : prefilter_{prefilter} {}

    /// What is kept of a network whose edges are all stretched, by interior face: both edges under a sensor know it.
    [[nodiscard]] static constexpr std::size_t bytes_per_face() {
        return Network::duplets_per_face * 2 * sizeof(SensorOver);
    }

    /// The duplets whose sensors trigger at the current state, ascending, each once. Always of the same network and state.
    [[nodiscard]] std::vector<LocalDuplet> sense(const Network& network, const State& state);

private:
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

        /// Forgets them; of the room, keeps about as much as some others take.
        void clear(const StretchedEdges& others);
    };

    void find_stretched(const Network& network, const State& state);
    void look_up(const Network& network, const State& state, Site site, int edge);
    [[nodiscard]] std::vector<LocalDuplet> find_triggered(const Network& network, const State& state) const;

    Prefilter prefilter_;
    /// An edge mostly stays stretched for many steps, and looking up what is at it costs more than all else: it is kept until one of its
    /// vertices is updated.
    StretchedEdges now_;
    StretchedEdges before_;
};

/// The prefilter's limits of the edges that go up along an axis from a vertex, by who carries them and which duplets are active.
void set_sensing_limits(const Network& network, VertexSite lower, int axis, State& state);

/// The same for all edges at some vertices, each named once, where unions fell apart or duplets became inactive.
void update_sensing(const Network& network, std::span<const VertexSite> vertices, State& state);

}  // namespace cracksim::physics
