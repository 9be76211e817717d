#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

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

/// The motion of the unions in one plane of a row, component after component, along a part of the row: whole groups of lanes that
/// the unions in it lie in, and their upper neighbours.
struct Chunk {
    std::int32_t begin{0};  ///< of the part, a multiple of the lanes
    std::int32_t length{0};
    std::size_t stride{0};  ///< from one component to the next
    bool advances{false};   ///< holds unions that this rank advances, not received masses only
    std::vector<std::uint8_t> group_advances;  ///< the same for each group of lanes
    std::vector<double, LineAllocator<double>> values;

    [[nodiscard]] bool covers(std::int32_t first, std::int32_t end) const {
        return length > 0 && begin <= first && end <= begin + length;
    }
    /// Where the first component of the row's first vertex would be; null if there is no union.
    [[nodiscard]] double* row_start() { return length == 0 ? nullptr : values.data() - begin; }
    [[nodiscard]] const double* row_start() const { return length == 0 ? nullptr : values.data() - begin; }
};

/// The motion of all unions of this rank. A plane takes memory where unions fell apart only.
class Motion {
public:
    Motion(const Lattice& lattice, bool extrapolates);

    [[nodiscard]] Chunk& chunk(std::int32_t row, int plane) { return chunks_[place(row, plane)]; }
    [[nodiscard]] const Chunk& chunk(std::int32_t row, int plane) const { return chunks_[place(row, plane)]; }

    /// Makes sure that a slot has memory; what is new is zero. advances: a union that this rank advances.
    void open(const Lattice& lattice, Slot s, bool advances);
    [[nodiscard]] Vec3 get(const Lattice& lattice, Slot s, std::size_t quantity) const;
    void set(const Lattice& lattice, Slot s, std::size_t quantity, Vec3 value);
    [[nodiscard]] double& mobility(const Lattice& lattice, Slot s);
    [[nodiscard]] double mobility(const Lattice& lattice, Slot s) const;
    /// All components of a slot to zero.
    void clear(const Lattice& lattice, Slot s);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    [[nodiscard]] static std::size_t place(std::int32_t row, int plane) {
        return static_cast<std::size_t>(row) * planes + static_cast<std::size_t>(plane);
    }
    /// A chunk and the place of a slot's first component in it.
    struct Place {
        std::size_t chunk;
        std::size_t at;
    };
    [[nodiscard]] Place find(const Lattice& lattice, Slot s) const;
    void extend(Chunk& chunk, std::int32_t begin, std::int32_t end, std::size_t stride) const;

    std::size_t components_;
    std::size_t base_stride_;  ///< the same in all rows
    std::vector<Chunk> chunks_;
};

}  // namespace cracksim::physics
