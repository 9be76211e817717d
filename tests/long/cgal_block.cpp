#include "tests/long/cgal_block.hpp"

#include <map>
#include <stdexcept>
#include <utility>

#include "tests/long/flag.hpp"

namespace cracksim::test {
namespace {

std::int64_t mass_at(std::int64_t entity, int corner) { return 8 * entity + vtk_corner(corner); }

/// The difference of the ids of neighbouring entities along each axis; ids count x fastest.
std::array<std::int64_t, 3> strides(const std::array<std::int64_t, 3>& cells) {
    return {1, cells[0], cells[0] * cells[1]};
}

std::int64_t place(const std::array<std::int64_t, 3>& cells, std::int64_t entity, int axis) {
    const auto a = static_cast<std::size_t>(axis);
    return entity / strides(cells)[a] % cells[a];
}

}  // namespace

CgalBlock::CgalBlock(std::array<std::int64_t, 3> cells) : cells_{cells} {
    const std::int64_t count = cells[0] * cells[1] * cells[2];
    darts_.resize(static_cast<std::size_t>(count * Flag::count));
    for (std::int64_t e = 0; e < count; ++e) {
        make_hexahedron(e);
    }
    for (std::int64_t e = 0; e < count; ++e) {
        for (int axis = 0; axis < 3; ++axis) {
            if (const std::int64_t other = upper_neighbour(e, axis); other >= 0) {
                const Flag lower_side{0, axis == 0 ? 1 : 0, axis};
                map_.sew<3>(upper_dart(e, axis), dart(dart_name(other, lower_side)));
            }
        }
    }
    start_unions();
}

void CgalBlock::make_hexahedron(std::int64_t entity) {
    const Dart first = map_.make_combinatorial_hexahedron();
    for (auto at = map_.darts_of_cell<3>(first).begin(); at != map_.darts_of_cell<3>(first).end(); ++at) {
        map_.info(at) = -1;
    }
    name_from(first, dart_name(entity, flag(0)));
}

void CgalBlock::name_from(Dart start, std::int64_t start_name) {
    std::vector<std::pair<Dart, std::int64_t>> found{{start, start_name}};
    for (std::size_t n = 0; n < found.size(); ++n) {
        const auto [at, name] = found[n];
        if (map_.info(at) >= 0) {
            if (map_.info(at) != name) {
                throw std::logic_error{"CGAL's hexahedron is not a cube"};
            }
            continue;
        }
        map_.info(at) = name;
        darts_[static_cast<std::size_t>(name)] = at;
        const auto next = [&](int i) { return dart_name(entity_of_dart(name), test::alpha(i, flag_of_dart(name))); };
        found.emplace_back(map_.alpha<0>(at), next(0));
        found.emplace_back(map_.alpha<1>(at), next(1));
        found.emplace_back(map_.alpha<2>(at), next(2));
    }
}

void CgalBlock::start_unions() {
    std::map<std::int64_t, std::int64_t> smallest_mass;
    union_of_.resize(darts_.size() / 6);
    masses_in_.resize(union_of_.size());
    for (std::int64_t m = 0; std::cmp_less(m, union_of_.size()); ++m) {
        const std::int64_t entity = m / 8;
        for (int corner = 0; corner < 8; ++corner) {
            if (mass_at(entity, corner) == m) {
                const std::int64_t id = smallest_mass.try_emplace(vertex(entity, corner), m).first->second;
                union_of_[static_cast<std::size_t>(m)] = id;
                ++masses_in_[static_cast<std::size_t>(id)];
            }
        }
    }
}

std::int64_t CgalBlock::upper_neighbour(std::int64_t entity, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    return place(cells_, entity, axis) + 1 < cells_[a] ? entity + strides(cells_)[a] : -1;
}

std::int64_t CgalBlock::vertex(std::int64_t entity, int corner) const {
    std::int64_t id = 0;
    for (int axis = 2; axis >= 0; --axis) {
        id = id * (cells_[static_cast<std::size_t>(axis)] + 1) + place(cells_, entity, axis) + (corner >> axis & 1);
    }
    return id;
}

CgalBlock::Dart CgalBlock::upper_dart(std::int64_t entity, int axis) const {
    return dart(dart_name(entity, {1 << axis, axis == 0 ? 1 : 0, axis}));
}

void CgalBlock::split(std::span<const PartedMass> masses) {
    while (!masses.empty()) {
        const PartedMass& first = masses.front();
        std::size_t size = 1;
        while (size < masses.size() && masses[size].step == first.step && masses[size].old_union == first.old_union) {
            ++size;
        }
        split_one(masses.first(size));
        masses = masses.subspan(size);
    }
}

void CgalBlock::split_one(std::span<const PartedMass> masses) {
    const auto whole = masses_in_[static_cast<std::size_t>(masses.front().old_union)];
    if (std::cmp_not_equal(masses.size(), whole)) {
        throw std::logic_error{"a split does not name all masses of its union"};
    }
    for (const PartedMass& m : masses) {
        std::int64_t& id = union_of_[static_cast<std::size_t>(m.mass)];
        if (id != m.old_union) {
            throw std::logic_error{"a split names a mass of another union, or one twice"};
        }
        --masses_in_[static_cast<std::size_t>(m.old_union)];
        ++masses_in_[static_cast<std::size_t>(m.new_union)];
        id = m.new_union;
    }
}

bool CgalBlock::shares_unions(std::int64_t lower, std::int64_t upper, int axis) const {
    for (int corner = 0; corner < 8; ++corner) {
        const bool on_face = (corner >> axis & 1) != 0;
        if (on_face && union_of_[static_cast<std::size_t>(mass_at(lower, corner))] !=
                           union_of_[static_cast<std::size_t>(mass_at(upper, corner ^ 1 << axis))]) {
            return false;
        }
    }
    return true;
}

void CgalBlock::unsew_parted_faces() {
    for (std::int64_t e = 0; std::cmp_less(e, darts_.size() / Flag::count); ++e) {
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t other = upper_neighbour(e, axis);
            const Dart on_face = upper_dart(e, axis);
            if (other >= 0 && !map_.is_free<3>(on_face) && !shares_unions(e, other, axis)) {
                map_.unsew<3>(on_face);
            }
        }
    }
}

std::int64_t CgalBlock::alpha(int i, std::int64_t name) const {
    const Dart at = dart(name);
    switch (i) {
        case 0: return map_.info(map_.alpha<0>(at));
        case 1: return map_.info(map_.alpha<1>(at));
        case 2: return map_.info(map_.alpha<2>(at));
        default: return map_.info(map_.alpha<3>(at));
    }
}

std::int64_t CgalBlock::free_face_count() const {
    std::int64_t darts = 0;
    for (const Dart at : darts_) {
        darts += map_.is_free<3>(at) ? 1 : 0;
    }
    return darts / 8;
}

std::int64_t CgalBlock::vertex_count() const { return map_.count_cells({0})[0]; }

std::int64_t CgalBlock::component_count() const { return map_.count_cells({4})[4]; }

}  // namespace cracksim::test
