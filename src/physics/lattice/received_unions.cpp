#include "physics/lattice/received_unions.hpp"

#include <algorithm>

#include "core/sorted.hpp"

namespace cracksim::physics {

namespace {

std::size_t row_of(const Unions& unions, VertexSite v) {
    return static_cast<std::size_t>(unions.lattice().vertex_row(v));
}

}  // namespace

ReceivedUnions::ReceivedUnions(const Network& network, const Unions& unions)
    : masses_in_row_(unions.lattice().vertex_rows().size()), unions_in_row_(masses_in_row_.size()) {
    for (std::size_t i = 0; i < network.received().size(); ++i) {
        masses_in_row_[row_of(unions, unions.lattice().vertex(network.received()[i]))].push_back(i);
    }
    for (std::size_t row = 0; row < masses_in_row_.size(); ++row) {
        find_in_row(network, unions, row);
    }
}

void ReceivedUnions::update(const Network& network, const Unions& unions, std::span<const VertexSite> vertices) {
    std::vector<std::size_t> rows;
    rows.reserve(vertices.size());
    for (const VertexSite v : vertices) {
        if (!unions.is_touched(v)) {
            rows.push_back(row_of(unions, v));
        }
    }
    sort_and_make_unique(rows);
    for (const std::size_t row : rows) {
        find_in_row(network, unions, row);
    }
}

void ReceivedUnions::find_in_row(const Network& network, const Unions& unions, std::size_t row) {
    std::vector<Entry>& found = unions_in_row_[row];
    found.clear();
    for (const std::size_t i : masses_in_row_[row]) {
        found.push_back({unions.union_of(network.received()[i]), i});
    }
    std::ranges::stable_sort(found, {}, &Entry::local_union);
    const auto same = [](const Entry& a, const Entry& b) { return a.local_union == b.local_union; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
}

std::size_t ReceivedUnions::memory_bytes() const {
    constexpr std::size_t of_row = sizeof(std::vector<std::size_t>) + sizeof(std::vector<Entry>);
    std::size_t bytes = masses_in_row_.size() * of_row;
    for (std::size_t row = 0; row < masses_in_row_.size(); ++row) {
        bytes += masses_in_row_[row].capacity() * sizeof(std::size_t) + unions_in_row_[row].capacity() * sizeof(Entry);
    }
    return bytes;
}

}  // namespace cracksim::physics
