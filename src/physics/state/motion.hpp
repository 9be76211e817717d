#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/contracts.hpp"
#include "core/vec3.hpp"
#include "physics/problem/lattice.hpp"

namespace cracksim::physics {

/// A Mass-union on this rank: 8 * vertex site + layer. Each part of the masses at a vertex has a layer of its own.
using LocalUnion = Id<struct LocalUnionTag, std::int32_t>;

constexpr int layers = 8;
/// The layer of the part with the vertex's smallest mass, so of every whole union except a lone mass.
constexpr int base_layer = 6;
[[nodiscard]] constexpr LocalUnion local_union(VertexSite v, int layer) {
    return LocalUnion{v.value() * layers + layer};
}
[[nodiscard]] constexpr VertexSite vertex_of(LocalUnion s) { return VertexSite{s.value() / layers}; }
[[nodiscard]] constexpr int layer_of(LocalUnion s) { return s.value() % layers; }

/// The IEEE 754 format in which the motion and its forces are stored and computed. Thresholds, positions and energies
/// are in double.
enum class Precision { binary64, binary32 };

/// Calls action(Real{}) with the type of the motion's numbers and returns what it returns.
auto in_precision(Precision precision, auto&& action) {
    return precision == Precision::binary32 ? action(float{}) : action(double{});
}

/// The quantities of a union, each by the index of its first component: u (m), w (m), the force on the union (N),
/// dt^2/M (s^2/kg), and for ab2 the extrapolated increment that damping uses instead of w (m).
struct Quantity {
    static constexpr std::size_t displacement = 0;
    static constexpr std::size_t increment = 3;
    static constexpr std::size_t force = 6;
    static constexpr std::size_t dt2_over_mass = 9;
    static constexpr std::size_t extrapolated = 10;
};

/// Allocates memory that begins at a cache line, so that vectors are aligned.
template <class T>
struct LineAllocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    LineAllocator() = default;
    template <class U>
    explicit LineAllocator(const LineAllocator<U>&) {}

    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), line)); }
    void deallocate(T* p, std::size_t) { ::operator delete(p, line); }
    friend bool operator==(const LineAllocator&, const LineAllocator&) { return true; }
};

/// The place of a union's numbers in the pool.
using PoolPlace = Id<struct PoolPlaceTag, std::int32_t>;

/// The layout of a union in the pool: u and dt^2/M; w and a zero; the force and a zero; for ab2, the extrapolated
/// increment and a zero.
struct Pooled {
    static constexpr std::size_t together = 4;
    static constexpr std::size_t dt2_over_mass = 3;

    /// The place of a quantity's first component; the other components follow.
    [[nodiscard]] static constexpr std::size_t at(std::size_t quantity) {
        return quantity == Quantity::dt2_over_mass ? dt2_over_mass : (quantity + 1) / 3 * together;
    }
};
static_assert(Pooled::at(Quantity::displacement) == 0 && Pooled::at(Quantity::increment) == 4 &&
              Pooled::at(Quantity::force) == 8 && Pooled::at(Quantity::extrapolated) == 12);

/// The numbers of a motion: the base layer, component after component, and the pool, union after union.
template <class Real>
class MotionNumbers {
public:
    explicit MotionNumbers(std::size_t base_size) : base_(base_size, Real{0}) {}

    [[nodiscard]] Real* base() { return base_.data(); }
    [[nodiscard]] const Real* base() const { return base_.data(); }
    [[nodiscard]] Real* pool() { return pool_.data(); }
    [[nodiscard]] const Real* pool() const { return pool_.data(); }
    [[nodiscard]] std::size_t pool_size() const { return pool_.size(); }
    /// Appends zeros for one more union.
    void extend_pool(std::size_t numbers_of_union);
    /// Moves the union at place order[i] to place i, for all i.
    void reorder_pool(std::size_t numbers_of_union, std::span<const PoolPlace> order);
    [[nodiscard]] std::size_t memory_bytes() const { return (base_.capacity() + pool_.capacity()) * sizeof(Real); }

private:
    std::vector<Real, LineAllocator<Real>> base_;
    std::vector<Real, LineAllocator<Real>> pool_;
};

/// The motion of all unions of this rank. The base layer has a place for each vertex site, component after component.
/// Unions in the other layers (parts of unions that split, and lone masses) are in the pool, union after union. The
/// pool is in the order in which the sweep meets the unions, except for those added since the last ordering.
class Motion {
public:
    Motion(const Lattice& lattice, bool extrapolates, Precision precision);

    [[nodiscard]] Precision precision() const {
        return std::holds_alternative<MotionNumbers<float>>(numbers_) ? Precision::binary32 : Precision::binary64;
    }
    /// A number as the motion stores it.
    [[nodiscard]] double rounded(double value) const {
        if (precision() == Precision::binary64) {
            return value;
        }
        // GCC 12 drops two successive conversions when it vectorizes several calls. A volatile variable prevents this.
        const volatile auto single = static_cast<float>(value);
        return single;
    }
    [[nodiscard]] Vec3 rounded(Vec3 value) const { return {rounded(value.x), rounded(value.y), rounded(value.z)}; }

    /// Ensures that a union has memory; new memory is zero. May move the pool.
    void open(LocalUnion s);
    [[nodiscard]] Vec3 get(LocalUnion s, std::size_t quantity) const {
        const auto values = [&](const auto& numbers) {
            const auto p = place(numbers, s, quantity);
            return Vec3{*p.first, p.first[p.stride], p.first[2 * p.stride]};
        };
        return std::visit(values, numbers_);
    }
    /// The numbers of a union that both schemes have.
    struct Moving {
        Vec3 displacement;
        Vec3 increment;
        Vec3 force;
        double dt2_over_mass;

        /// In double, without supports.
        [[nodiscard]] Vec3 next_increment() const { return increment + dt2_over_mass * force; }
    };
    [[nodiscard]] Moving moving(LocalUnion s) const {
        const auto values = [&](const auto& numbers) {
            const auto vector = [&](std::size_t quantity) {
                const auto p = place(numbers, s, quantity);
                return Vec3{*p.first, p.first[p.stride], p.first[2 * p.stride]};
            };
            return Moving{vector(Quantity::displacement), vector(Quantity::increment), vector(Quantity::force),
                          *place(numbers, s, Quantity::dt2_over_mass).first};
        };
        return std::visit(values, numbers_);
    }
    void set(LocalUnion s, std::size_t quantity, Vec3 value);
    [[nodiscard]] double dt2_over_mass(LocalUnion s) const {
        return std::visit(
            [&](const auto& numbers) -> double { return *place(numbers, s, Quantity::dt2_over_mass).first; }, numbers_);
    }
    void set_dt2_over_mass(LocalUnion s, double value);
    /// Copies all components of a union to another union, which must have memory.
    void copy(LocalUnion from, LocalUnion to);
    /// Sets all components of a union to zero.
    void clear(LocalUnion s);
    /// Sets the forces of all unions to zero.
    void clear_forces();

    /// The numbers. Real must be the motion's precision.
    template <class Real>
    [[nodiscard]] MotionNumbers<Real>& in() {
        return std::get<MotionNumbers<Real>>(numbers_);
    }
    template <class Real>
    [[nodiscard]] const MotionNumbers<Real>& in() const {
        return std::get<MotionNumbers<Real>>(numbers_);
    }
    [[nodiscard]] std::size_t base_stride() const { return base_stride_; }
    /// Distance from one union to the next in the pool.
    [[nodiscard]] std::size_t pool_stride() const { return pool_stride_; }
    /// None if the union is in the base layer or has no memory.
    [[nodiscard]] PoolPlace pool_place(LocalUnion s) const {
        const std::int32_t index = pooled_at_[vertex_of(s).index()];
        return index < 0 ? PoolPlace{}
                         : places_[static_cast<std::size_t>(index)][static_cast<std::size_t>(layer_of(s))];
    }
    /// The first pooled union at a row of vertices whose layer is a corner on a side, or none.
    [[nodiscard]] PoolPlace first_pooled(std::size_t row, std::size_t side) const { return first_pooled_[row][side]; }
    /// [place in the pool]: the next union of the same row and side, or none.
    [[nodiscard]] const PoolPlace* next_pooled() const { return next_pooled_.data(); }
    /// True if so many unions were added since the last ordering that the sweep would miss the caches.
    [[nodiscard]] bool is_disordered() const;
    /// Orders the pool: unions that the same row of cells meets first become neighbours. Changes all places in the
    /// pool.
    void order_pool(const Lattice& lattice);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// The first component of a quantity and the distance to the next component.
    template <class T>
    struct Components {
        T* first;
        std::size_t stride;
    };
    template <class Numbers>
    using ComponentsIn = Components<std::remove_pointer_t<decltype(std::declval<Numbers&>().base())>>;
    using PlacesOfVertex = std::array<PoolPlace, layers>;

    template <class Numbers>
    [[nodiscard]] ComponentsIn<Numbers> place(Numbers& numbers, LocalUnion s, std::size_t quantity) const {
        if (layer_of(s) == base_layer) {
            return {numbers.base() + quantity * base_stride_ + vertex_of(s).index(), base_stride_};
        }
        const PoolPlace pooled = pool_place(s);
        CRACKSIM_EXPECT(pooled != PoolPlace{});
        return {numbers.pool() + pooled.index() * pool_stride_ + Pooled::at(quantity), 1};
    }

    void order_by_vertex();
    /// Appends the old places of the unions at a row of vertices and on a side to `order`, and gives these unions their
    /// new places.
    void append_pooled(const Lattice& lattice, std::size_t row, std::size_t side, std::vector<PoolPlace>& order);

    bool extrapolates_;
    std::size_t base_stride_;
    std::size_t pool_stride_;
    std::variant<MotionNumbers<double>, MotionNumbers<float>> numbers_;
    std::vector<std::int32_t> row_of_group_;  ///< vertex row by group of `lanes` vertex sites
    std::vector<std::int32_t> pooled_at_;     ///< by vertex site: index into places_, -1 if no union of it is pooled
    std::vector<PlacesOfVertex> places_;      ///< for each vertex with pooled unions: their places by layer
    std::vector<std::array<PoolPlace, Lattice::sides>> first_pooled_;  ///< by row of vertices and side
    std::vector<PoolPlace> next_pooled_;
    std::size_t disordered_{0};
};

}  // namespace cracksim::physics
