#include "physics/motion.hpp"

#include <algorithm>
#include <bit>

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

constexpr std::size_t lanes = Lattice::lanes;

/// In whole cache lines, and so that the components of a vertex fall on different sets of the cache.
std::size_t stride_for(std::size_t sites) {
    constexpr std::size_t lines_of_page = 64;
    constexpr std::size_t apart = 11;
    const std::size_t lines = sites / lanes + 1;
    return ((lines + lines_of_page - 1 - apart) / lines_of_page * lines_of_page + apart) * lanes;
}

}  // namespace

Motion::Motion(const Lattice& lattice, bool extrapolates)
    : components_{Quantity::mobility + 1 + (extrapolates ? 3U : 0U)},
      base_stride_{stride_for(lattice.vertex_sites())},
      base_(components_ * base_stride_, 0.0),
      blocks_(guard, 0.0),
      block_of_(lattice.vertex_sites() / lanes * planes, -1),
      planes_in_use_(lattice.vertex_sites() / lanes, 0) {}

void Motion::open(Slot s) {
    const std::size_t group = vertex_of(s).index() / lanes;
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(plane_of(s)));
    if (plane_of(s) == base_plane || (planes_in_use_[group] & bit) != 0) {
        return;
    }
    if (guard + (block_count_ + 1) * block_size() > blocks_.size()) {
        make_room();
    }
    block_of_[entry(group, plane_of(s))] = static_cast<std::int32_t>(block_count_++);
    planes_in_use_[group] |= bit;
}

/// Half as many blocks again, and all of them in the order in which the sweep meets them.
void Motion::make_room() {
    LineVector wider(guard + (block_count_ + block_count_ / 2 + lanes) * block_size(), 0.0);
    double* to = wider.data();
    std::int32_t next = 0;
    for (std::size_t group = 0; group < planes_in_use_.size(); ++group) {
        for (unsigned bits = planes_in_use_[group]; bits != 0; bits &= bits - 1) {
            std::int32_t& index = block_of_[entry(group, std::countr_zero(bits))];
            to = std::copy_n(blocks() + static_cast<std::size_t>(index) * block_size(), block_size(), to);
            index = next++;
        }
    }
    blocks_ = std::move(wider);
}

void Motion::set(Slot s, std::size_t quantity, Vec3 value) {
    CRACKSIM_EXPECT(quantity + 3 <= components_);
    const Place<double> p = place(s);
    *p.at(quantity) = value.x;
    *p.at(quantity + 1) = value.y;
    *p.at(quantity + 2) = value.z;
}

void Motion::copy(Slot from, Slot to) {
    const Place<const double> source = std::as_const(*this).place(from);
    const Place<double> target = place(to);
    for (std::size_t component = 0; component < components_; ++component) {
        *target.at(component) = *source.at(component);
    }
}

void Motion::clear(Slot s) {
    const Place<double> p = place(s);
    for (std::size_t component = 0; component < components_; ++component) {
        *p.at(component) = 0;
    }
}

void Motion::clear_forces() {
    std::fill_n(base_.data() + Quantity::force * base_stride_, 3 * base_stride_, 0.0);
    for (std::size_t i = 0; i < block_count_; ++i) {
        std::fill_n(blocks() + i * block_size() + Quantity::force * block_stride, 3 * block_stride, 0.0);
    }
}

std::size_t Motion::memory_bytes() const {
    return (base_.capacity() + blocks_.capacity()) * sizeof(double) + block_of_.capacity() * sizeof(std::int32_t) +
           planes_in_use_.capacity();
}

}  // namespace cracksim::physics
