#include "scene/notches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unordered_set>

#include "core/text.hpp"
#include "scene/keys.hpp"
#include "scene/readers.hpp"

namespace cracksim::scene {

namespace {

using io::InputNode;

constexpr std::size_t most_notches = 10'000;
constexpr std::size_t most_corners = 1'000;
/// Of the block's size: coordinates beyond it leave no digits for the position of a cut.
constexpr double farthest = 1e6;

struct Box {
    Vec3 lower;
    Vec3 upper;
};

Box box_of(const Block& block) {
    Box box{block.origin(), block.origin()};
    for (int axis = 0; axis < 3; ++axis) {
        box.upper[axis] += static_cast<double>(block.cells()[static_cast<std::size_t>(axis)]) * block.edge()[axis];
    }
    return box;
}

double shortest_edge(const Block& block) { return std::min({block.edge().x, block.edge().y, block.edge().z}); }

/// A position, or a vector between two, that is not too far from the block.
Vec3 read_point(const InputNode& node, const Block& block) {
    const Box box = box_of(block);
    const Vec3 value = vector(node);
    const double reach = std::max({norm(box.lower), norm(box.upper), norm(box.upper - box.lower)});
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(value[axis]) > farthest * reach) {
            node.fail("has " + std::string{"xyz"[axis]} + " = " + rounded(value[axis], 3) +
                      " m, more than a million times the block's reach of " + rounded(reach, 3) +
                      " m; give lengths in m");
        }
    }
    return value;
}

RectangleSettings read_rectangle(const InputNode& node, const Block& block) {
    node.expect_keys(keys_of("notches.*.where.rectangle"));
    return {read_point(node.at("corner"), block), read_point(node.at("along"), block),
            read_point(node.at("and"), block)};
}

DiscSettings read_disc(const InputNode& node, const Block& block) {
    node.expect_keys(keys_of("notches.*.where.disc"));
    return {read_point(node.at("centre"), block), vector(node.at("normal")), positive(node.at("radius"), "m")};
}

PolygonSettings read_polygon(const InputNode& node, const Block& block) {
    const auto items = node.list();
    if (items.size() > most_corners) {
        node.fail("has more than " + std::to_string(most_corners) + " corners; divide it into several notches");
    }
    PolygonSettings polygon;
    for (const InputNode& item : items) {
        polygon.corners.push_back(read_point(item, block));
    }
    return polygon;
}

std::variant<RectangleSettings, DiscSettings, PolygonSettings> read_shape(const InputNode& where, const Block& block) {
    where.expect_keys(keys_of("notches.*.where"));
    const MaybeNode rectangle = where.find("rectangle");
    const MaybeNode disc = where.find("disc");
    const MaybeNode polygon = where.find("polygon");
    const int given = (rectangle ? 1 : 0) + (disc ? 1 : 0) + (polygon ? 1 : 0);
    if (given != 1) {
        where.fail((given == 0 ? "needs a surface: " : "needs one surface, not " + std::to_string(given) + ": ") +
                   std::string{"rectangle: {corner, along, and}, disc: {centre, normal, radius} or polygon: "
                               "[[x, y, z], ...]"});
    }
    if (rectangle) {
        return read_rectangle(*rectangle, block);
    }
    if (disc) {
        return read_disc(*disc, block);
    }
    return read_polygon(*polygon, block);
}

physics::PlanarSurface surface_of(const NotchSettings& notch, double scale) {
    if (const auto* rectangle = std::get_if<RectangleSettings>(&notch.where)) {
        return physics::PlanarSurface::rectangle(rectangle->corner, rectangle->along, rectangle->across, scale);
    }
    if (const auto* disc = std::get_if<DiscSettings>(&notch.where)) {
        return physics::PlanarSurface::disc(disc->centre, disc->normal, disc->radius, scale);
    }
    return physics::PlanarSurface::polygon(std::get<PolygonSettings>(notch.where).corners, scale);
}

std::string reach_text(double lower, double upper, const std::string& axis) {
    constexpr int digits = 9;
    return lower == upper
               ? "lies at " + axis + " = " + rounded(lower, digits) + " m"
               : "reaches from " + axis + " = " + rounded(lower, digits) + " to " + rounded(upper, digits) + " m";
}

/// Throws InputError for a surface that is degenerate or outside of the block.
void check_surface(const InputNode& where, const NotchSettings& notch, const Block& block) {
    const std::string name = "'" + notch.name + "' ";
    try {
        const auto [lower, upper] = surface_of(notch, shortest_edge(block)).bounds();
        const Box box = box_of(block);
        for (int axis = 0; axis < 3; ++axis) {
            if (upper[axis] < box.lower[axis] || lower[axis] > box.upper[axis]) {
                const std::string name_of_axis{"xyz"[axis]};
                where.fail(name + "lies outside of the block: the notch " +
                           reach_text(lower[axis], upper[axis], name_of_axis) + ", the block " +
                           reach_text(box.lower[axis], box.upper[axis], name_of_axis) + "; move the notch");
            }
        }
    } catch (const std::invalid_argument& reason) {
        where.fail(name + reason.what());
    }
}

NotchSettings read_notch(const InputNode& node, std::size_t index, const Block& block) {
    node.expect_keys(keys_of("notches.*"));
    const MaybeNode name = node.find("name");
    const InputNode where = node.at("where");
    NotchSettings notch{name ? line(*name, 60) : "notch " + std::to_string(index), read_shape(where, block),
                        where.place()};
    check_surface(where, notch, block);
    return notch;
}

}  // namespace

std::vector<NotchSettings> read_notches(const InputNode& root, const Block& block) {
    std::vector<NotchSettings> all;
    const MaybeNode node = root.find("notches");
    const auto items = node ? node->list() : std::vector<InputNode>{};
    if (items.size() > most_notches) {
        node->fail("has more than " + std::to_string(most_notches) + " notches; join their surfaces");
    }
    std::unordered_set<std::string> names;
    for (const InputNode& item : items) {
        NotchSettings notch = read_notch(item, all.size(), block);
        if (!names.insert(notch.name).second) {
            item.fail("there is a notch named '" + notch.name + "' already; choose another name");
        }
        all.push_back(std::move(notch));
    }
    return all;
}

std::vector<physics::Notch> notches(const std::vector<NotchSettings>& settings, const Block& block) {
    std::vector<physics::Notch> all;
    all.reserve(settings.size());
    for (const NotchSettings& notch : settings) {
        all.push_back({notch.name, surface_of(notch, shortest_edge(block))});
    }
    return all;
}

}  // namespace cracksim::scene
