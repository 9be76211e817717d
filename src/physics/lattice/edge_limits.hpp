#pragma once

#include <cstddef>
#include <vector>

#include "physics/lattice/bfloat16.hpp"
#include "physics/problem/entity_model.hpp"
#include "physics/problem/lattice.hpp"

namespace cracksim::physics {

/// The sensing limit of each entity's edges: the quadratic strain |d|^2/L0^2 - 1 up to which no sensor that reaches
/// over the edge can trigger. It is infinite if there is no such sensor or the entity does not represent the edge. The
/// lowest limit of each half batch is kept as well, because most sweeps need only this.
class EdgeLimits {
public:
    /// All limits are infinite.
    explicit EdgeLimits(const Lattice& lattice);

    [[nodiscard]] Bfloat16 of(Site site, int edge) const { return by_edge_[place(site, edge)]; }
    void set(Site site, int edge, Bfloat16 limit);

    /// [batch][edge][lane]
    [[nodiscard]] const Bfloat16* by_edge() const { return by_edge_.data(); }
    /// [half of a batch]
    [[nodiscard]] const Bfloat16* lowest() const { return lowest_.data(); }
    [[nodiscard]] std::size_t memory_bytes() const {
        return (by_edge_.capacity() + lowest_.capacity()) * sizeof(Bfloat16);
    }
    friend bool operator==(const EdgeLimits&, const EdgeLimits&) = default;

    static constexpr std::size_t of_batch = HexahedronPairs::edges * std::size_t{Lattice::lanes};

private:
    [[nodiscard]] static std::size_t place(Site site, int edge) {
        return site.index() / Lattice::lanes * of_batch + static_cast<std::size_t>(edge * Lattice::lanes) +
               site.index() % Lattice::lanes;
    }
    [[nodiscard]] Bfloat16 lowest_in(std::size_t half) const;

    std::vector<Bfloat16> by_edge_;
    std::vector<Bfloat16> lowest_;
};

}  // namespace cracksim::physics
