#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "physics/problem/network.hpp"
#include "physics/state/unions.hpp"

namespace cracksim::physics {

/// The unions of the received masses. All masses of a received union have the same increment, so only one of them is
/// read.
class ReceivedUnions {
public:
    struct Entry {
        LocalUnion local_union;
        std::size_t mass;  ///< index into Network::received
    };

    ReceivedUnions(const Network& network, const Unions& unions);

    /// Must be called with the vertices where masses have new part numbers.
    void update(const Network& network, const Unions& unions, std::span<const VertexSite> vertices);
    /// The received unions at a row of vertices, each once.
    [[nodiscard]] std::span<const Entry> in_row(std::size_t row) const { return unions_in_row_[row]; }
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    void find_in_row(const Network& network, const Unions& unions, std::size_t row);

    std::vector<std::vector<std::size_t>> masses_in_row_;  ///< indices into Network::received
    std::vector<std::vector<Entry>> unions_in_row_;
};

}  // namespace cracksim::physics
