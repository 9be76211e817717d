#include "physics/state/motion.hpp"

#include <algorithm>
#include <utility>

#include "core/contracts.hpp"
#include "core/growth.hpp"

namespace cracksim::physics {

namespace {

constexpr std::size_t lanes = Lattice::lanes;

/// The distance between two components in the base layer: a whole number of vectors, which are whole cache lines for
/// doubles, such that the components of a vertex fall into different sets of the cache.
std::size_t stride_for(std::size_t sites) {
    constexpr std::size_t lines_of_page = 64;
    constexpr std::size_t apart = 11;
    const std::size_t lines = sites / lanes + 1;
    return ((lines + lines_of_page - 1 - apart) / lines_of_page * lines_of_page + apart) * lanes;
}

std::variant<MotionNumbers<double>, MotionNumbers<float>> numbers_in(Precision precision, std::size_t base_size) {
    if (precision == Precision::binary32) {
        return MotionNumbers<float>{base_size};
    }
    return MotionNumbers<double>{base_size};
}

/// Calls action(quantity, components) for each quantity of a union.
void for_each_quantity(bool extrapolates, auto&& action) {
    action(Quantity::displacement, 3);
    action(Quantity::increment, 3);
    action(Quantity::force, 3);
    action(Quantity::dt2_over_mass, 1);
    if (extrapolates) {
        action(Quantity::extrapolated, 3);
    }
}

}  // namespace

template <class Real>
void MotionNumbers<Real>::extend_pool(std::size_t numbers_of_union) {
    make_room(pool_, numbers_of_union);
    pool_.resize(pool_.size() + numbers_of_union, Real{0});
}

template <class Real>
void MotionNumbers<Real>::reorder_pool(std::size_t numbers_of_union, std::span<const PoolPlace> order) {
    std::vector<Real, LineAllocator<Real>> ordered;
    ordered.reserve(pool_.capacity());
    for (const PoolPlace place : order) {
        const auto from = pool_.cbegin() + static_cast<std::ptrdiff_t>(place.index() * numbers_of_union);
        ordered.insert(ordered.end(), from, from + static_cast<std::ptrdiff_t>(numbers_of_union));
    }
    pool_ = std::move(ordered);
}

template class MotionNumbers<double>;
template class MotionNumbers<float>;

Motion::Motion(const Lattice& lattice, bool extrapolates, Precision precision)
    : extrapolates_{extrapolates},
      base_stride_{stride_for(lattice.vertex_sites())},
      pool_stride_{Pooled::together * (extrapolates ? 4U : 3U)},
      numbers_{numbers_in(precision, (Quantity::dt2_over_mass + 1 + (extrapolates ? 3U : 0U)) * base_stride_)},
      pooled_at_(lattice.vertex_sites(), -1),
      first_pooled_(lattice.vertex_rows().size()) {
    for (std::size_t group = 0; group < lattice.vertex_sites() / lanes; ++group) {
        row_of_group_.push_back(lattice.vertex_row(VertexSite{static_cast<std::int32_t>(group * lanes)}));
    }
}

void Motion::open(LocalUnion s) {
    if (layer_of(s) == base_layer) {
        return;
    }
    const std::size_t v = vertex_of(s).index();
    if (pooled_at_[v] < 0) {
        pooled_at_[v] = static_cast<std::int32_t>(places_.size());
        make_room(places_, 1);
        places_.emplace_back();
    }
    PoolPlace& found = places_[static_cast<std::size_t>(pooled_at_[v])][static_cast<std::size_t>(layer_of(s))];
    if (found == PoolPlace{}) {
        found = PoolPlace{static_cast<std::int32_t>(next_pooled_.size())};
        std::visit([&](auto& numbers) { numbers.extend_pool(pool_stride_); }, numbers_);
        PoolPlace& first =
            first_pooled_[static_cast<std::size_t>(row_of_group_[v / lanes])][Lattice::side(layer_of(s))];
        make_room(next_pooled_, 1);
        next_pooled_.push_back(std::exchange(first, found));
        ++disordered_;
    }
}

bool Motion::is_disordered() const {
    constexpr std::size_t not_worth_it = 64;
    return disordered_ > not_worth_it + next_pooled_.size() / 8;
}

void Motion::order_pool(const Lattice& lattice) {
    order_by_vertex();
    std::vector<PoolPlace> order;
    order.reserve(next_pooled_.size());
    for (const Lattice::CellRow& cells : lattice.cell_rows()) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            append_pooled(lattice, static_cast<std::size_t>(cells.vertex_row[side]), side, order);
        }
    }
    for (std::size_t row = 0; row < first_pooled_.size(); ++row) {
        for (std::size_t side = 0; side < Lattice::sides; ++side) {
            if (lattice.vertex_rows()[row].cell_row[side] < 0) {
                append_pooled(lattice, row, side, order);
            }
        }
    }
    CRACKSIM_EXPECT(order.size() == next_pooled_.size());
    std::visit([&](auto& numbers) { numbers.reorder_pool(pool_stride_, order); }, numbers_);
    disordered_ = 0;
}

void Motion::order_by_vertex() {
    std::vector<PlacesOfVertex> ordered;
    ordered.reserve(places_.capacity());
    for (std::int32_t& at : pooled_at_) {
        if (at >= 0) {
            ordered.push_back(places_[static_cast<std::size_t>(at)]);
            at = static_cast<std::int32_t>(ordered.size()) - 1;
        }
    }
    places_ = std::move(ordered);
}

void Motion::append_pooled(const Lattice& lattice, std::size_t row, std::size_t side, std::vector<PoolPlace>& order) {
    const Lattice::VertexRow& vertices = lattice.vertex_rows()[row];
    const std::size_t first = order.size();
    for (const std::int32_t at : std::span{pooled_at_}.subspan(static_cast<std::size_t>(vertices.first),
                                                               static_cast<std::size_t>(vertices.length))) {
        for (int layer = 0; at >= 0 && layer < layers; ++layer) {
            PoolPlace& place = places_[static_cast<std::size_t>(at)][static_cast<std::size_t>(layer)];
            if (Lattice::side(layer) == side && place != PoolPlace{}) {
                order.push_back(place);
                place = PoolPlace{static_cast<std::int32_t>(order.size()) - 1};
            }
        }
    }
    PoolPlace next;
    for (std::size_t place = order.size(); place > first; --place) {
        next_pooled_[place - 1] = next;
        next = PoolPlace{static_cast<std::int32_t>(place) - 1};
    }
    first_pooled_[row][side] = next;
}

void Motion::set(LocalUnion s, std::size_t quantity, Vec3 value) {
    CRACKSIM_EXPECT(quantity != Quantity::extrapolated || extrapolates_);
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        const Components<Real> p = place(numbers, s, quantity);
        p.first[0] = static_cast<Real>(value.x);
        p.first[p.stride] = static_cast<Real>(value.y);
        p.first[2 * p.stride] = static_cast<Real>(value.z);
    };
    std::visit(assign, numbers_);
}

void Motion::set_dt2_over_mass(LocalUnion s, double value) {
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        *place(numbers, s, Quantity::dt2_over_mass).first = static_cast<Real>(value);
    };
    std::visit(assign, numbers_);
}

void Motion::copy(LocalUnion from, LocalUnion to) {
    const auto assign = [&](auto& numbers) {
        for_each_quantity(extrapolates_, [&](std::size_t quantity, std::size_t components) {
            const auto source = place(numbers, from, quantity);
            const auto target = place(numbers, to, quantity);
            for (std::size_t i = 0; i < components; ++i) {
                target.first[i * target.stride] = source.first[i * source.stride];
            }
        });
    };
    std::visit(assign, numbers_);
}

void Motion::clear(LocalUnion s) {
    const auto assign = [&](auto& numbers) {
        for_each_quantity(extrapolates_, [&](std::size_t quantity, std::size_t components) {
            const auto p = place(numbers, s, quantity);
            for (std::size_t i = 0; i < components; ++i) {
                p.first[i * p.stride] = 0;
            }
        });
    };
    std::visit(assign, numbers_);
}

void Motion::clear_forces() {
    const auto assign = [&]<class Real>(MotionNumbers<Real>& numbers) {
        std::fill_n(numbers.base() + Quantity::force * base_stride_, 3 * base_stride_, Real{0});
        for (std::size_t at = 0; at < numbers.pool_size(); at += pool_stride_) {
            std::fill_n(numbers.pool() + at + Pooled::at(Quantity::force), 3, Real{0});
        }
    };
    std::visit(assign, numbers_);
}

std::size_t Motion::memory_bytes() const {
    return std::visit([](const auto& numbers) { return numbers.memory_bytes(); }, numbers_) +
           (row_of_group_.capacity() + pooled_at_.capacity()) * sizeof(std::int32_t) +
           places_.capacity() * sizeof(PlacesOfVertex) + next_pooled_.capacity() * sizeof(PoolPlace) +
           first_pooled_.capacity() * sizeof(first_pooled_.front());
}

}  // namespace cracksim::physics
