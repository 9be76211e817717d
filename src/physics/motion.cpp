#include "physics/motion.hpp"

#include <algorithm>
#include <bit>

#include "core/contracts.hpp"

namespace cracksim::physics {

namespace {

constexpr std::size_t lanes = Lattice::lanes;

/// In whole vectors, of doubles in whole cache lines, and so that the components of a vertex fall on different sets of the cache.
std::size_t stride_for(std::size_t sites) {
    constexpr std::size_t lines_of_page = 64;
    constexpr std::size_t apart = 11;
    const std::size_t lines = sites / lanes + 1;
    return ((lines + lines_of_page - 1 - apart) / lines_of_page * lines_of_page + apart) * lanes;
}

std::variant<MotionNumbers<double>, MotionNumbers<float>> numbers_in(Precision precision, std::size_t base_size,
                                                                     std::size_t blocks_size) {
    if (precision == Precision::binary32) {
        return MotionNumbers<float>{base_size, blocks_size};
    }
    return MotionNumbers<double>{base_size, blocks_size};
}

}  // namespace

template <class Real>
void MotionNumbers<Real>::reorder_blocks(std::size_t size, std::size_t block_size,
                                         const std::vector<std::int32_t>& order) {
    std::vector<Real, LineAllocator<Real>> reordered(size, Real{0});
    Real* to = reordered.data();
    for (const std::int32_t index : order) {
        to = std::copy_n(blocks() + static_cast<std::size_t>(index) * block_size, block_size, to);
    }
    blocks_ = std::move(reordered);
}

template class MotionNumbers<double>;
template class MotionNumbers<float>;

Motion::Motion(const Lattice& lattice, bool extrapolates, Precision precision)
    : components_{Quantity::mobility + 1 + (extrapolates ? 3U : 0U)},
      base_stride_{stride_for(lattice.vertex_sites())},
      numbers_{numbers_in(precision, components_ * base_stride_, guard)},
      block_of_(lattice.vertex_sites() / lanes * planes, -1),
      planes_in_use_(lattice.vertex_sites() / lanes, 0),
      planes_in_row_(lattice.vertex_rows().size(), 0) {
    for (std::size_t group = 0; group < planes_in_use_.size(); ++group) {
        row_of_group_.push_back(lattice.vertex_row(VertexSite{static_cast<std::int32_t>(group * lanes)}));
    }
}

void Motion::open(Slot s) {
    const std::size_t group = vertex_of(s).index() / lanes;
    const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(plane_of(s)));
    if (plane_of(s) == base_plane || (planes_in_use_[group] & bit) != 0) {
        return;
    }
    const std::size_t room = std::visit([](const auto& numbers) { return numbers.blocks_size(); }, numbers_);
    if (guard + (block_count_ + 1) * block_size() > room) {
        make_room();
    }
    block_of_[entry(group, plane_of(s))] = static_cast<std::int32_t>(block_count_++);
    planes_in_use_[group] |= bit;
    planes_in_row_[static_cast<std::size_t>(row_of_group_[group])] |= bit;
}

/// Half as many blocks again, and all of them in the order in which the sweep meets them.
void Motion::make_room() {
    std::vector<std::int32_t> order;
    for (std::size_t group = 0; group < planes_in_use_.size(); ++group) {
        for (unsigned bits = planes_in_use_[group]; bits != 0; bits &= bits - 1) {
            std::int32_t& index = block_of_[entry(group, std::countr_zero(bits))];
            order.push_back(index);
            index = static_cast<std::int32_t>(order.size()) - 1;
        }
    }
    const std::size_t size = guard + (block_count_ + block_count_ / 2 + lanes) * block_size();
    std::visit([&](auto& numbers) { numbers.reorder_blocks(size, block_size(), order); }, numbers_);
}

void Motion::set(Slot s, std::size_t quantity, Vec3 value) {
    CRACKSIM_EXPECT(quantity + 3 <= components_);
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        const Place<Real> p = place(numbers, s);
        *p.at(quantity) = static_cast<Real>(value.x);
        *p.at(quantity + 1) = static_cast<Real>(value.y);
        *p.at(quantity + 2) = static_cast<Real>(value.z);
    };
    std::visit(assign, numbers_);
}

void Motion::set_mobility(Slot s, double value) {
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        *place(numbers, s).at(Quantity::mobility) = static_cast<Real>(value);
    };
    std::visit(assign, numbers_);
}

void Motion::copy(Slot from, Slot to) {
    const auto assign = [&](auto& numbers) {
        const auto source = place(numbers, from);
        const auto target = place(numbers, to);
        for (std::size_t component = 0; component < components_; ++component) {
            *target.at(component) = *source.at(component);
        }
    };
    std::visit(assign, numbers_);
}

void Motion::clear(Slot s) {
    const auto assign = [&](auto& numbers) {
        const auto p = place(numbers, s);
        for (std::size_t component = 0; component < components_; ++component) {
            *p.at(component) = 0;
        }
    };
    std::visit(assign, numbers_);
}

void Motion::clear_forces() {
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        std::fill_n(numbers.base() + Quantity::force * base_stride_, 3 * base_stride_, Real{0});
        for (std::size_t i = 0; i < block_count_; ++i) {
            std::fill_n(numbers.blocks() + i * block_size() + Quantity::force * block_stride, 3 * block_stride,
                        Real{0});
        }
    };
    std::visit(assign, numbers_);
}

std::size_t Motion::memory_bytes() const {
    return std::visit([](const auto& numbers) { return numbers.memory_bytes(); }, numbers_) +
           (block_of_.capacity() + row_of_group_.capacity()) * sizeof(std::int32_t) + planes_in_use_.capacity() +
           planes_in_row_.capacity();
}

}  // namespace cracksim::physics
