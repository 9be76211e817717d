#include "surface/surface_update.hpp"

#include <cstring>

#include "core/contracts.hpp"

namespace cracksim::surface {
namespace {

template <class T>
std::size_t packed_size(const std::vector<T>& values) {
    return sizeof(std::uint64_t) + values.size() * sizeof(T);
}

/// Writes the values at `to` and returns the position after them.
template <class T>
std::byte* pack(const std::vector<T>& values, std::byte* to) {
    const std::uint64_t count = values.size();
    std::memcpy(to, &count, sizeof count);
    if (count > 0) {
        std::memcpy(to + sizeof count, values.data(), count * sizeof(T));
    }
    return to + packed_size(values);
}

template <class T>
void take(std::span<const std::byte>& bytes, std::vector<T>& values) {
    std::uint64_t count = 0;
    CRACKSIM_EXPECT(bytes.size() >= sizeof count);
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes = bytes.subspan(sizeof count);
    CRACKSIM_EXPECT(bytes.size() >= count * sizeof(T));
    values.resize(count);
    if (count > 0) {
        std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    }
    bytes = bytes.subspan(count * sizeof(T));
}

}  // namespace

std::vector<std::byte> packed(const SurfaceUpdate& update) {
    std::vector<std::byte> bytes(packed_size(update.new_points) + packed_size(update.changed_faces) +
                                 packed_size(update.fragments) + packed_size(update.positions));
    std::byte* to = pack(update.new_points, bytes.data());
    to = pack(update.changed_faces, to);
    to = pack(update.fragments, to);
    pack(update.positions, to);
    return bytes;
}

std::vector<SurfaceUpdate> unpacked(std::span<const std::byte> bytes) {
    std::vector<SurfaceUpdate> all;
    while (!bytes.empty()) {
        SurfaceUpdate& update = all.emplace_back();
        take(bytes, update.new_points);
        take(bytes, update.changed_faces);
        take(bytes, update.fragments);
        take(bytes, update.positions);
    }
    return all;
}

}  // namespace cracksim::surface
