#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/problem/network.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// The unions that this rank advances and another rank owns (it owns the entity of their smallest mass), by rows. Sums
/// over the owned unions leave them out.
class ForeignUnions {
public:
    ForeignUnions(const Network& network, const Unions& unions);

    /// Must be called with the vertices where masses have new part numbers.
    void update(const Network& network, const Unions& unions, std::span<const VertexSite> vertices);
    /// The foreign unions at a row of vertices.
    [[nodiscard]] std::span<const LocalUnion> in_row(std::size_t row) const { return unions_in_row_[row]; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    bool any_foreign_{false};  ///< whether a local entity is foreign
    std::vector<std::vector<LocalUnion>> unions_in_row_;
};

}  // namespace cracksim::physics
