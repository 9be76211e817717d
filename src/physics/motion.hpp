#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "core/vec3.hpp"
#include "physics/lattice.hpp"

namespace cracksim::physics {

/// Place of a Mass-union's motion: 8 * vertex + plane. The planes of a vertex are for the parts that its masses fell into.
using Slot = Id<struct SlotTag, std::int32_t>;

constexpr int planes = 8;
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

/// The motion of all unions of this rank: for each row of vertices and each plane in use there a chunk, which holds component after
/// component along the row. A plane takes memory from the first union in it on.
class Motion {
public:
    Motion(const Lattice& lattice, bool extrapolates);

    /// The chunk of a plane of a row; null if it holds no union.
    [[nodiscard]] double* chunk(std::int32_t row, int plane) { return chunks_[place(row, plane)].data(); }
    [[nodiscard]] const double* chunk(std::int32_t row, int plane) const { return chunks_[place(row, plane)].data(); }
    /// From one component to the next.
    [[nodiscard]] std::size_t stride(std::int32_t row) const { return stride_[static_cast<std::size_t>(row)]; }

    /// Makes sure that a slot has memory; what is new is zero.
    void open(const Lattice& lattice, Slot s);
    [[nodiscard]] Vec3 get(const Lattice& lattice, Slot s, std::size_t quantity) const;
    void set(const Lattice& lattice, Slot s, std::size_t quantity, Vec3 value);
    [[nodiscard]] double& mobility(const Lattice& lattice, Slot s);
    [[nodiscard]] double mobility(const Lattice& lattice, Slot s) const;
    /// All components of a slot to zero.
    void clear(const Lattice& lattice, Slot s);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    using Chunk = std::vector<double, LineAllocator<double>>;

    [[nodiscard]] static std::size_t place(std::int32_t row, int plane) {
        return static_cast<std::size_t>(row) * planes + static_cast<std::size_t>(plane);
    }
    /// Of the first component of a slot in its chunk.
    [[nodiscard]] static std::size_t along(const Lattice& lattice, Slot s);

    std::size_t components_;
    std::vector<std::size_t> stride_;
    std::vector<Chunk> chunks_;
};

}  // namespace cracksim::physics
