#include "physics/motion.hpp"

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

constexpr std::size_t line = 8;

/// An odd number of cache lines: the components of long rows then fall on different sets of the cache.
std::size_t stride_for(std::int32_t length) {
    const std::size_t lines = (static_cast<std::size_t>(length) + line - 1) / line;
    return (lines | 1U) * line;
}

}  // namespace

Motion::Motion(const Lattice& lattice, bool extrapolates)
    : components_{Quantity::mobility + 1 + (extrapolates ? 3U : 0U)} {
    for (const Lattice::VertexRow& row : lattice.vertex_rows()) {
        stride_.push_back(stride_for(row.length));
    }
    chunks_.resize(stride_.size() * planes);
}

std::size_t Motion::along(const Lattice& lattice, Slot s) {
    const auto row = static_cast<std::size_t>(lattice.vertex_row(vertex_of(s)));
    return static_cast<std::size_t>(vertex_of(s).value() - lattice.vertex_rows()[row].first);
}

void Motion::open(const Lattice& lattice, Slot s) {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    Chunk& opened = chunks_[place(row, plane_of(s))];
    if (opened.empty()) {
        // The last lanes of a row load one value beyond the last component.
        opened.resize(components_ * stride(row) + line);
    }
}

Vec3 Motion::get(const Lattice& lattice, Slot s, std::size_t quantity) const {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    const double* at = chunk(row, plane_of(s)) + quantity * stride(row) + along(lattice, s);
    return {at[0], at[stride(row)], at[2 * stride(row)]};
}

void Motion::set(const Lattice& lattice, Slot s, std::size_t quantity, Vec3 value) {
    CRACKSIM_EXPECT(quantity + 3 <= components_);
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    double* at = chunk(row, plane_of(s)) + quantity * stride(row) + along(lattice, s);
    at[0] = value.x;
    at[stride(row)] = value.y;
    at[2 * stride(row)] = value.z;
}

double& Motion::mobility(const Lattice& lattice, Slot s) {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    return chunk(row, plane_of(s))[Quantity::mobility * stride(row) + along(lattice, s)];
}

double Motion::mobility(const Lattice& lattice, Slot s) const {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    return chunk(row, plane_of(s))[Quantity::mobility * stride(row) + along(lattice, s)];
}

void Motion::clear(const Lattice& lattice, Slot s) {
    const std::int32_t row = lattice.vertex_row(vertex_of(s));
    double* at = chunk(row, plane_of(s)) + along(lattice, s);
    for (std::size_t component = 0; component < components_; ++component) {
        at[component * stride(row)] = 0;
    }
}

std::size_t Motion::memory_bytes() const {
    std::size_t bytes = stride_.capacity() * sizeof(std::size_t) + chunks_.capacity() * sizeof(Chunk);
    for (const Chunk& c : chunks_) {
        bytes += c.capacity() * sizeof(double);
    }
    return bytes;
}

}  // namespace cracksim::physics
