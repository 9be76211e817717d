#include "surface/gathered_surface.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

#include "core/contracts.hpp"
#include "surface/frame_meshes.hpp"
#include "surface/sorted_keys.hpp"

namespace cracksim::surface {
namespace {

enum Integer : std::uint8_t { entity, fragment };
enum Real : std::uint8_t { opened_at, opening };
constexpr std::size_t first_real = 2;
constexpr std::size_t corners = 4;

geometry::Mesh empty_mesh(const Block& block) {
    const MeshLayout layout = surface_layout(block);
    CRACKSIM_EXPECT(layout.integer_names.size() == first_real);
    geometry::Mesh mesh;
    for (const std::string& name : layout.integer_names) {
        mesh.fields.push_back({name, std::vector<std::int64_t>{}});
    }
    for (const std::string& name : layout.real_names) {
        mesh.fields.push_back({name, std::vector<double>{}});
    }
    return mesh;
}

}  // namespace

GatheredSurface::GatheredSurface(const Block& block, std::size_t ranks)
    : block_{block}, orders_(ranks), surface_{empty_mesh(block)}, crack_{empty_mesh(block)} {}

std::vector<double>& GatheredSurface::reals(std::size_t field) {
    return std::get<std::vector<double>>(surface_.fields[first_real + field].values);
}

std::vector<std::int64_t>& GatheredSurface::integers(std::size_t field) {
    return std::get<std::vector<std::int64_t>>(surface_.fields[field].values);
}

void GatheredSurface::take(std::span<const SurfaceUpdate> update) {
    CRACKSIM_EXPECT(update.size() == orders_.size());
    add_points(update);
    add_faces(update);
    move(update);
    name_fragments(update);
    measure_openings();
}

void GatheredSurface::add_points(std::span<const SurfaceUpdate> update) {
    std::vector<MassId> added;
    for (const SurfaceUpdate& rank : update) {
        added.insert(added.end(), rank.new_points.begin(), rank.new_points.end());
    }
    keep_new(added, point_keys_);
    if (!added.empty()) {
        const Places moved = merge(point_keys_, added);
        for (std::int64_t& point : surface_.connectivity) {
            point = moved[static_cast<std::size_t>(point)];
        }
        for (Order& order : orders_) {
            rename(order.point, moved);
        }
    }
    for (std::size_t r = 0; r < update.size(); ++r) {
        for (const MassId key : update[r].new_points) {
            orders_[r].point.push_back(place_in(point_keys_, key));
        }
    }
}

void GatheredSurface::add_faces(std::span<const SurfaceUpdate> update) {
    std::vector<std::int64_t> added;
    for (const SurfaceUpdate& rank : update) {
        for (const SurfaceUpdate::Face& face : rank.changed_faces) {
            added.push_back(face.key);
        }
    }
    crack_is_old_ = crack_is_old_ || !added.empty();
    keep_new(added, face_keys_);
    make_room(merge(face_keys_, added));
    for (std::size_t r = 0; r < update.size(); ++r) {
        for (const SurfaceUpdate::Face& face : update[r].changed_faces) {
            if (std::ranges::binary_search(added, face.key)) {
                orders_[r].face.push_back(place_in(face_keys_, face.key));
                set_met(face);
            }
            set_face(face);
        }
    }
}

void GatheredSurface::make_room(const Places& moved) {
    const std::size_t size = face_keys_.size();
    if (size == moved.size()) {
        return;
    }
    spread(surface_.connectivity, moved, size, corners);
    spread(integers(entity), moved, size, 1);
    spread(integers(fragment), moved, size, 1);
    spread(reals(opened_at), moved, size, 1);
    reals(opening).assign(size, 0.0);
    rename(met_, moved);
    spread(met_, moved, size, 1);
    for (Order& order : orders_) {
        rename(order.face, moved);
    }
}

void GatheredSurface::set_face(const SurfaceUpdate::Face& face) {
    const std::size_t place = place_of(face.key);
    integers(entity)[place] = face.key / Hexahedron::faces;
    reals(opened_at)[place] = face.opened_at;
    for (std::size_t k = 0; k < corners; ++k) {
        surface_.connectivity[place * corners + k] = place_in(point_keys_, face.points[k]);
    }
}

void GatheredSurface::set_met(const SurfaceUpdate::Face& face) {
    const auto other =
        block_.neighbour(EntityId{face.key / Hexahedron::faces}, static_cast<int>(face.key % Hexahedron::faces));
    met_[place_of(face.key)] =
        other ? place_in(face_keys_, other->entity.value() * Hexahedron::faces + other->face) : -1;
}

std::size_t GatheredSurface::place_of(std::int64_t face_key) const {
    return static_cast<std::size_t>(place_in(face_keys_, face_key));
}

void GatheredSurface::move(std::span<const SurfaceUpdate> update) {
    surface_.points.resize(point_keys_.size());
    for (std::size_t r = 0; r < update.size(); ++r) {
        for (std::size_t i = 0; i < update[r].positions.size(); ++i) {
            surface_.points[static_cast<std::size_t>(orders_[r].point[i])] = update[r].positions[i];
        }
    }
}

void GatheredSurface::name_fragments(std::span<const SurfaceUpdate> update) {
    for (std::size_t r = 0; r < update.size(); ++r) {
        for (std::size_t i = 0; i < update[r].fragments.size(); ++i) {
            integers(fragment)[static_cast<std::size_t>(orders_[r].face[i])] = update[r].fragments[i].value();
        }
    }
}

void GatheredSurface::find_crack() {
    if (!std::exchange(crack_is_old_, false)) {
        return;
    }
    crack_faces_.clear();
    for (std::size_t f = 0; f < met_.size(); ++f) {
        if (met_[f] >= 0) {
            crack_faces_.push_back(static_cast<std::int32_t>(f));
        }
    }
    number_crack_points();
}

void GatheredSurface::number_crack_points() {
    std::vector<std::int64_t> number(point_keys_.size(), -1);
    for (const std::int32_t f : crack_faces_) {
        for (std::size_t k = 0; k < corners; ++k) {
            number[static_cast<std::size_t>(surface_.connectivity[static_cast<std::size_t>(f) * corners + k])] = 0;
        }
    }
    crack_points_.clear();
    for (std::size_t p = 0; p < number.size(); ++p) {
        if (number[p] == 0) {
            number[p] = static_cast<std::int64_t>(crack_points_.size());
            crack_points_.push_back(static_cast<std::int32_t>(p));
        }
    }
    crack_.connectivity.clear();
    for (const std::int32_t f : crack_faces_) {
        for (std::size_t k = 0; k < corners; ++k) {
            const std::int64_t point = surface_.connectivity[static_cast<std::size_t>(f) * corners + k];
            crack_.connectivity.push_back(number[static_cast<std::size_t>(point)]);
        }
    }
}

void GatheredSurface::measure_openings() {
    find_crack();
    for (const std::int32_t face : crack_faces_) {
        if (const std::int32_t other = met_[static_cast<std::size_t>(face)]; face < other) {
            measure_opening(face, other);
        }
    }
}

// The distances are the same from both sides, but each side adds them in the order of its own corners.
void GatheredSurface::measure_opening(std::int32_t face, std::int32_t other) {
    const std::int64_t key = face_keys_[static_cast<std::size_t>(face)];
    const auto link = block_.neighbour(EntityId{key / Hexahedron::faces}, static_cast<int>(key % Hexahedron::faces));
    const auto met = [&](std::size_t k) {
        return static_cast<std::size_t>(place_met(link->rotation, static_cast<int>(k)));
    };
    const auto point = [&](std::int32_t of, std::size_t k) {
        return surface_
            .points[static_cast<std::size_t>(surface_.connectivity[static_cast<std::size_t>(of) * corners + k])];
    };
    std::array<double, corners> distance{};
    double from_here = 0;
    double from_there = 0;
    for (std::size_t k = 0; k < corners; ++k) {
        distance[k] = norm(point(other, met(k)) - point(face, k));
        from_here += distance[k];
    }
    for (std::size_t k = 0; k < corners; ++k) {
        from_there += distance[met(k)];
    }
    reals(opening)[static_cast<std::size_t>(face)] = 0.25 * from_here;
    reals(opening)[static_cast<std::size_t>(other)] = 0.25 * from_there;
}

const geometry::Mesh& GatheredSurface::crack() {
    pick(surface_.points, crack_points_, crack_.points);
    for (std::size_t field = 0; field < surface_.fields.size(); ++field) {
        std::visit(
            [&](const auto& values) {
                pick(values, crack_faces_, std::get<std::decay_t<decltype(values)>>(crack_.fields[field].values));
            },
            surface_.fields[field].values);
    }
    return crack_;
}

}  // namespace cracksim::surface
