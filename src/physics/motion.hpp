#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/contracts.hpp"
#include "core/vec3.hpp"
#include "physics/lattice.hpp"

namespace cracksim::physics {

/// Place of a Mass-union's motion: 8 * vertex + plane. The planes of a vertex are for the parts that its masses fell into.
using Slot = Id<struct SlotTag, std::int32_t>;

constexpr int planes = 8;
/// Holds the part with the vertex's smallest mass, and so every whole union but lone masses.
constexpr int base_plane = 6;
[[nodiscard]] constexpr Slot slot_of(VertexSite v, int plane) { return Slot{v.value() * planes + plane}; }
[[nodiscard]] constexpr VertexSite vertex_of(Slot s) { return VertexSite{s.value() / planes}; }
[[nodiscard]] constexpr int plane_of(Slot s) { return s.value() % planes; }

/// What the motion and its forces are kept and computed in, by IEEE 754's names. Thresholds, positions and energies are in double.
enum class Precision { binary64, binary32 };

/// What a slot holds, as the first of its components: u (m), w (m), the force on the union (N), dt^2/M (s^2/kg), and with ab2
/// what damping takes for w (m).
struct Quantity {
    static constexpr std::size_t displacement = 0;
    static constexpr std::size_t increment = 3;
    static constexpr std::size_t force = 6;
    static constexpr std::size_t mobility = 9;
    static constexpr std::size_t extrapolated = 10;
};

/// Whole cache lines, for aligned vectors.
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

/// The numbers of a motion: the base plane, component after component, and the blocks one after the other.
template <class Real>
class MotionNumbers {
public:
    MotionNumbers(std::size_t base_size, std::size_t blocks_size)
        : base_(base_size, Real{0}), blocks_(blocks_size, Real{0}) {}

    [[nodiscard]] Real* base() { return base_.data(); }
    [[nodiscard]] const Real* base() const { return base_.data(); }
    [[nodiscard]] Real* blocks() { return blocks_.data(); }
    [[nodiscard]] const Real* blocks() const { return blocks_.data(); }
    [[nodiscard]] std::size_t blocks_size() const { return blocks_.size(); }
    /// All of another size, zero but for blocks that were there: block i of the new ones is the old block order[i].
    void reorder_blocks(std::size_t size, std::size_t block_size, const std::vector<std::int32_t>& order);
    [[nodiscard]] std::size_t memory_bytes() const { return (base_.capacity() + blocks_.capacity()) * sizeof(Real); }

private:
    std::vector<Real, LineAllocator<Real>> base_;
    std::vector<Real, LineAllocator<Real>> blocks_;
};

/// The motion of all unions of this rank. The base plane has a place for each vertex, component after component. Of the other planes
/// there are blocks for the groups of vertices in which unions fell apart: of a group's lanes, component after component.
class Motion {
public:
    /// From one component to the next in a block.
    static constexpr std::size_t block_stride = Lattice::lanes;

    Motion(const Lattice& lattice, bool extrapolates, Precision precision);

    [[nodiscard]] Precision precision() const {
        return std::holds_alternative<MotionNumbers<float>>(numbers_) ? Precision::binary32 : Precision::binary64;
    }
    /// A number as the motion keeps it.
    [[nodiscard]] double rounded(double value) const {
        if (precision() == Precision::binary64) {
            return value;
        }
        // GCC 12 leaves two conversions in a row out where it makes a vector of several numbers; not over memory.
        const volatile auto single = static_cast<float>(value);
        return single;
    }
    [[nodiscard]] Vec3 rounded(Vec3 value) const { return {rounded(value.x), rounded(value.y), rounded(value.z)}; }

    /// Makes sure that a slot has memory; what is new is zero. Moves the blocks.
    void open(Slot s);
    [[nodiscard]] Vec3 get(Slot s, std::size_t quantity) const {
        const auto values = [&](const auto& numbers) {
            const auto p = place(numbers, s);
            return Vec3{*p.at(quantity), *p.at(quantity + 1), *p.at(quantity + 2)};
        };
        return std::visit(values, numbers_);
    }
    void set(Slot s, std::size_t quantity, Vec3 value);
    [[nodiscard]] double mobility(Slot s) const {
        return std::visit([&](const auto& numbers) -> double { return *place(numbers, s).at(Quantity::mobility); },
                          numbers_);
    }
    void set_mobility(Slot s, double value);
    /// All components of a slot to another one, which has memory.
    void copy(Slot from, Slot to);
    /// All components of a slot to zero.
    void clear(Slot s);
    /// The forces of all slots to zero.
    void clear_forces();

    /// The numbers; of the motion's own precision. A vector that begins in a block may be read and written whole: what it reaches
    /// into is memory, too.
    template <class Real>
    [[nodiscard]] MotionNumbers<Real>& in() {
        return std::get<MotionNumbers<Real>>(numbers_);
    }
    [[nodiscard]] std::size_t base_stride() const { return base_stride_; }
    [[nodiscard]] std::size_t block_size() const { return components_ * block_stride; }
    /// [group of vertices][plane]: which block that is, -1 if there is none.
    [[nodiscard]] const std::int32_t* block_of() const { return block_of_.data(); }
    /// [group of vertices]: bit p is set where plane p has a block.
    [[nodiscard]] const std::vector<std::uint8_t>& planes_in_use() const { return planes_in_use_; }
    /// By vertex row: bit p is set where plane p has a block.
    [[nodiscard]] unsigned planes_in_row(std::size_t row) const { return planes_in_row_[row]; }
    /// The first number of a block of a group of vertices.
    template <class Real>
    [[nodiscard]] Real* block(std::size_t group, int plane) {
        return in<Real>().blocks() + static_cast<std::size_t>(block_of_[entry(group, plane)]) * block_size();
    }

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    static constexpr std::size_t guard = Lattice::lanes;

    template <class T>
    struct Place {
        T* first;
        std::size_t stride;

        [[nodiscard]] T* at(std::size_t component) const { return first + component * stride; }
    };

    [[nodiscard]] static std::size_t entry(std::size_t group, int plane) {
        return group * planes + static_cast<std::size_t>(plane);
    }
    template <class Numbers>
    using PlaceIn = Place<std::remove_pointer_t<decltype(std::declval<Numbers&>().base())>>;

    template <class Numbers>
    [[nodiscard]] PlaceIn<Numbers> place(Numbers& numbers, Slot s) const {
        const std::size_t v = vertex_of(s).index();
        if (plane_of(s) == base_plane) {
            return {numbers.base() + v, base_stride_};
        }
        const std::int32_t index = block_of_[entry(v / Lattice::lanes, plane_of(s))];
        CRACKSIM_EXPECT(index >= 0);
        return {numbers.blocks() + static_cast<std::size_t>(index) * block_size() + v % Lattice::lanes, block_stride};
    }
    void make_room();

    std::size_t components_;
    std::size_t base_stride_;
    std::variant<MotionNumbers<double>, MotionNumbers<float>> numbers_;
    std::size_t block_count_{0};
    std::vector<std::int32_t> block_of_;
    std::vector<std::uint8_t> planes_in_use_;
    std::vector<std::int32_t> row_of_group_;
    std::vector<std::uint8_t> planes_in_row_;
};

}  // namespace cracksim::physics
