#include "surface/surface_update.hpp"

#include <cstring>

#include "core/contracts.hpp"

namespace cracksim::surface {
namespace {

template <class T>
std::size_t packed_size(const std::vector<T>& values) {
    return sizeof(std::uint64_t) + values.size() * sizeof(T);
}

/// Writes at `to` and returns what follows.
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

std::vector<std::byte> packed(const SurfaceNews& news) {
    std::vector<std::byte> bytes(packed_size(news.new_points) + packed_size(news.changed_faces) +
                                 packed_size(news.fragments) + packed_size(news.positions));
    std::byte* to = pack(news.new_points, bytes.data());
    to = pack(news.changed_faces, to);
    to = pack(news.fragments, to);
    pack(news.positions, to);
    return bytes;
}

std::vector<SurfaceNews> unpacked(std::span<const std::byte> bytes) {
    std::vector<SurfaceNews> all;
    while (!bytes.empty()) {
        SurfaceNews& news = all.emplace_back();
        take(bytes, news.new_points);
        take(bytes, news.changed_faces);
        take(bytes, news.fragments);
        take(bytes, news.positions);
    }
    return all;
}

}  // namespace cracksim::surface
