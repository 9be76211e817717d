#include "physics/motion.hpp"

#include <algorithm>

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

constexpr std::int32_t lanes = Lattice::lanes;

std::int32_t whole_groups_down(std::int32_t at) { return at / lanes * lanes; }

/// An odd number of cache lines: the components of long rows then fall on different sets of the cache.
std::size_t stride_for(std::int32_t length) {
    const auto lines = static_cast<std::size_t>(length / lanes);
    return (lines | 1U) * static_cast<std::size_t>(lanes);
}

}  // namespace

Motion::Motion(const Lattice& lattice, bool extrapolates)
    : components_{Quantity::mobility + 1 + (extrapolates ? 3U : 0U)},
      base_stride_{0},
      chunks_(lattice.vertex_rows().size() * planes) {
    for (const Lattice::VertexRow& row : lattice.vertex_rows()) {
        base_stride_ = std::max(base_stride_, stride_for(row.length));
    }
}

Motion::Place Motion::find(const Lattice& lattice, Slot s) const {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    const std::int32_t along = vertex_of(s).value() - lattice.vertex_rows()[static_cast<std::size_t>(row)].first;
    const std::size_t index = place(row, plane_of(s));
    CRACKSIM_EXPECT(chunks_[index].covers(along, along + 1));
    return {index, static_cast<std::size_t>(along - chunks_[index].begin)};
}

void Motion::open(const Lattice& lattice, Slot s, bool advances) {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    const Lattice::VertexRow& vertices = lattice.vertex_rows()[static_cast<std::size_t>(row)];
    const std::int32_t along = vertex_of(s).value() - vertices.first;
    Chunk& opened = chunk(row, plane_of(s));
    // All vectors that have the vertex as one of their lanes.
    const std::int32_t begin = whole_groups_down(std::max(along - (lanes - 1), 0));
    const std::int32_t end = std::min(whole_groups_down(along + lanes - 1) + lanes, vertices.length);
    if (!opened.covers(begin, end)) {
        // Twice as long at least: a crack that runs along the row copies each union once or twice.
        const std::int32_t from = opened.length == 0 ? begin : std::min(begin, opened.begin);
        const std::int32_t to = opened.length == 0 ? end : std::max(end, opened.begin + opened.length);
        const std::int32_t more = opened.length == 0 ? 0 : std::max(0, 2 * opened.length - (to - from));
        const bool upward = opened.length == 0 || end > opened.begin + opened.length;
        const std::int32_t first = upward ? from : std::max(0, whole_groups_down(from - more));
        const std::int32_t last = upward ? std::min(vertices.length, to + more) : to;
        extend(opened, first, last, plane_of(s) == base_plane ? base_stride_ : stride_for(last - first));
    }
    if (advances) {
        opened.advances = true;
        opened.group_advances[static_cast<std::size_t>((along - opened.begin) / lanes)] = 1;
    }
}

void Motion::extend(Chunk& chunk, std::int32_t begin, std::int32_t end, std::size_t stride) const {
    Chunk longer{begin, end - begin, stride, chunk.advances, {}, {}};
    longer.group_advances.resize(static_cast<std::size_t>(longer.length / lanes), 0);
    std::ranges::copy(chunk.group_advances, longer.group_advances.begin() + (chunk.length > 0 ? (chunk.begin - begin) / lanes : 0));
    // The last lanes of a part load one value beyond its last component.
    longer.values.resize(components_ * longer.stride + static_cast<std::size_t>(lanes));
    for (std::size_t component = 0; chunk.length > 0 && component < components_; ++component) {
        std::copy_n(chunk.values.data() + component * chunk.stride, chunk.length,
                    longer.row_start() + component * longer.stride + chunk.begin);
    }
    chunk = std::move(longer);
}

Vec3 Motion::get(const Lattice& lattice, Slot s, std::size_t quantity) const {
    const auto [index, at] = find(lattice, s);
    const Chunk& c = chunks_[index];
    const double* first = c.values.data() + quantity * c.stride + at;
    return {first[0], first[c.stride], first[2 * c.stride]};
}

void Motion::set(const Lattice& lattice, Slot s, std::size_t quantity, Vec3 value) {
    CRACKSIM_EXPECT(quantity + 3 <= components_);
    const auto [index, at] = find(lattice, s);
    Chunk& c = chunks_[index];
    double* first = c.values.data() + quantity * c.stride + at;
    first[0] = value.x;
    first[c.stride] = value.y;
    first[2 * c.stride] = value.z;
}

double& Motion::mobility(const Lattice& lattice, Slot s) {
    const auto [index, at] = find(lattice, s);
    return chunks_[index].values[Quantity::mobility * chunks_[index].stride + at];
}

double Motion::mobility(const Lattice& lattice, Slot s) const {
    const auto [index, at] = find(lattice, s);
    return chunks_[index].values[Quantity::mobility * chunks_[index].stride + at];
}

void Motion::clear(const Lattice& lattice, Slot s) {
    const auto [index, at] = find(lattice, s);
    for (std::size_t component = 0; component < components_; ++component) {
        chunks_[index].values[component * chunks_[index].stride + at] = 0;
    }
}

std::size_t Motion::memory_bytes() const {
    std::size_t bytes = chunks_.capacity() * sizeof(Chunk);
    for (const Chunk& c : chunks_) {
        bytes += c.values.capacity() * sizeof(double) + c.group_advances.capacity();
    }
    return bytes;
}

}  // namespace cracksim::physics
