#include "physics/lattice/foreign_unions.hpp"

namespace cracksim::physics {

ForeignUnions::ForeignUnions(const Network& network, const Unions& unions)
    : unions_in_row_(unions.lattice().vertex_rows().size()) {
    for (LocalEntity e{0}; e.value() < network.entity_count(); ++e) {
        any_foreign_ = any_foreign_ || !network.owned(e);
    }
    unions.for_each_advanced([&](LocalUnion s, LocalMass smallest) {
        if (!network.owned(entity_of(smallest))) {
            unions_in_row_[static_cast<std::size_t>(unions.lattice().vertex_row(vertex_of(s)))].push_back(s);
        }
    });
}

void ForeignUnions::update(const Network& network, const Unions& unions, std::span<const VertexSite> vertices) {
    if (!any_foreign_) {
        return;
    }
    for (const VertexSite v : vertices) {
        std::vector<LocalUnion>& found = unions_in_row_[static_cast<std::size_t>(unions.lattice().vertex_row(v))];
        std::erase_if(found, [&](LocalUnion s) { return vertex_of(s) == v; });
        unions.lattice().for_each_mass_at(v, [&](LocalMass m) {
            const bool is_smallest = unions.is_touched(v) && unions.smallest_of_advanced(unions.union_of(m)) == m;
            if (is_smallest && !network.owned(entity_of(m))) {
                found.push_back(unions.union_of(m));
            }
        });
    }
}

std::size_t ForeignUnions::memory_bytes() const {
    std::size_t bytes = unions_in_row_.size() * sizeof(std::vector<LocalUnion>);
    for (const auto& unions : unions_in_row_) {
        bytes += unions.capacity() * sizeof(LocalUnion);
    }
    return bytes;
}

}  // namespace cracksim::physics
