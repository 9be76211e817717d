#include "scene/body_and_material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "io/text_file.hpp"
#include "scene/calibration.hpp"
#include "scene/readers.hpp"
#include "scene/words.hpp"

namespace cracksim::scene {

namespace {

using io::InputNode;

constexpr MaterialModel default_model = MaterialModel::standard;
constexpr double default_poisson = 0.25;

Vec3 read_edge(const InputNode& node) {
    Vec3 edge;
    if (node.is_list()) {
        edge = vector(node);
    } else {
        edge.x = edge.y = edge.z = positive(node, "m");
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(edge[axis] >= 1e-60 && edge[axis] <= 1e60)) {
            node.fail("every edge must be above 0 m and within 1e-60 to 1e60 m, not " + io::exact(edge[axis]));
        }
    }
    return edge;
}

std::array<std::int64_t, 3> read_cells(const InputNode& node) {
    constexpr std::int64_t most = 2'000'000'000;
    std::array<std::int64_t, 3> cells{};
    std::int64_t entities = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cells[axis] = node.list(3)[axis].integer(1, most);
        if (cells[axis] > most / entities) {
            node.fail("makes more than " + std::to_string(most) +
                      " entities, the most that a block may have; use fewer cells");
        }
        entities *= cells[axis];
    }
    return cells;
}

void check_resolution(const InputNode& node, const Block& block) {
    for (int axis = 0; axis < 3; ++axis) {
        const double upper = block.origin()[axis] +
                             static_cast<double>(block.cells()[static_cast<std::size_t>(axis)]) * block.edge()[axis];
        const double farthest = std::max(std::abs(block.origin()[axis]), std::abs(upper));
        if (!(block.edge()[axis] > 1e-12 * farthest)) {
            node.fail("lies so far from 0 along " + std::string{"xyz"[axis]} + " (" + io::exact(farthest) +
                      " m) that positions one edge apart are hardly told apart; move block.origin closer to 0");
        }
    }
}

MaterialModel read_model(const InputNode& node) {
    const MaybeNode model = node.find("model");
    return model ? enumerator(*model, material_models) : default_model;
}

std::string edges_text(Vec3 edge) {
    return io::exact(edge.x) + " x " + io::exact(edge.y) + " x " + io::exact(edge.z) + " m";
}

/// Throws InputError for boxes so slender that rounding errors decide whether the energy of an entity is positive.
void check_standard_boxes(const InputNode& node, const Block& block) {
    constexpr double most = 1e6;
    const Vec3 edge = block.edge();
    if (std::max({edge.x, edge.y, edge.z}) > most * shortest_edge(block)) {
        node.fail(
            "takes boxes whose longest edge is at most a million times the shortest with model: standard, but "
            "block.edge is " +
            edges_text(edge) + "; use edges that differ less");
    }
}

/// Throws InputError if no 16 interactions make the block isotropic with this ratio.
void check_paper_material(const InputNode& node, const Block& block) {
    const Vec3 edge = block.edge();
    if (!has_equal_components(edge)) {
        node.fail("needs cubes with model: paper, but block.edge is " + edges_text(edge) +
                  ": no 16 interactions make other boxes isotropic; use equal edges, or model: standard");
    }
    if (const MaybeNode poisson = node.find("poisson"); poisson && poisson->number() != default_poisson) {
        poisson->fail("must be 0.25 with model: paper, not " + poisson->shown() +
                      ": the network of interactions is isotropic only there; use model: standard");
    }
}

double read_poisson(const InputNode& node) {
    const MaybeNode poisson = node.find("poisson");
    if (!poisson) {
        return default_poisson;
    }
    const double value = poisson->number();
    if (!(value >= physics::lowest_poisson && value <= physics::highest_poisson)) {
        poisson->fail("needs a number from " + io::exact(physics::lowest_poisson) + " to " +
                      io::exact(physics::highest_poisson) + ", not " + poisson->shown() +
                      ": the energy of the standard entity is proved to be positive there");
    }
    return value;
}

Material read_material(const InputNode& node, const Block& block) {
    node.expect_keys(keys_of("material"));
    const MaterialModel model = read_model(node);
    if (model == MaterialModel::paper) {
        check_paper_material(node, block);
    } else {
        check_standard_boxes(node, block);
    }
    const MaybeNode damping = node.find("damping");
    const MaybeNode energy = node.find("fracture_energy");
    return {model,
            positive(node.at("young"), "Pa"),
            positive(node.at("density"), "kg/m3"),
            read_poisson(node),
            damping ? not_negative(*damping, "a/c0") : 0.2,
            energy ? std::optional{positive(*energy, "J/m2")} : std::nullopt};
}

double read_viscosity(const InputNode& interaction) {
    const MaybeNode viscosity = interaction.find("viscosity");
    return viscosity ? not_negative(*viscosity, "N s/m") : 0.0;
}

NetworkSettings read_network(const InputNode& node) {
    node.expect_keys(keys_of("network"));
    const InputNode edge = node.at("edge");
    const InputNode diagonal = node.at("diagonal");
    edge.expect_keys(keys_of("network.edge"));
    diagonal.expect_keys(keys_of("network.diagonal"));
    return {positive(node.at("mass"), "kg"),
            {positive(edge.at("stiffness"), "N/m"), read_viscosity(edge)},
            {not_negative(diagonal.at("stiffness"), "N/m"), read_viscosity(diagonal)}};
}

/// Throws InputError for values so extreme that only a wrong unit can cause them; such values would overflow later.
void check_range(const InputNode& node, const NetworkSettings& network) {
    struct Quantity {
        const char* name;
        const char* unit;
        double value;
        bool may_vanish;
    };
    const std::array<Quantity, 5> quantities{{{"a mass", "kg", network.mass, false},
                                              {"an edge stiffness", "N/m", network.edge.stiffness, false},
                                              {"a diagonal stiffness", "N/m", network.diagonal.stiffness, true},
                                              {"an edge viscosity", "N s/m", network.edge.viscosity, true},
                                              {"a diagonal viscosity", "N s/m", network.diagonal.viscosity, true}}};
    for (const auto& [name, unit, value, may_vanish] : quantities) {
        if (!(value >= 1e-60 && value <= 1e60) && !(may_vanish && value == 0)) {
            node.fail("makes " + std::string{name} + " of " + rounded(value, 3) + " " + unit +
                      ", outside of 1e-60 to 1e60; check the units (SI) here and of block.edge");
        }
    }
}

}  // namespace

Block read_block(const InputNode& node) {
    constexpr std::array<std::string_view, 1> entities{"hexahedron"};
    constexpr std::array<std::string_view, 3> later{"tetrahedron", "quadrilateral", "triangle"};
    node.expect_keys(keys_of("block"));
    if (const MaybeNode entity = node.find("entity")) {
        static_cast<void>(available_word(*entity, entities, later));
    }
    const auto cells = read_cells(node.at("cells"));
    const Vec3 edge = read_edge(node.at("edge"));
    const MaybeNode origin = node.find("origin");
    const Block block{cells, edge, origin ? vector(*origin) : Vec3{}};
    check_resolution(node, block);
    return block;
}

Matter read_matter(const InputNode& root, const Block& block) {
    const MaybeNode material_node = root.find("material");
    const MaybeNode network_node = root.find("network");
    if (material_node && network_node) {
        network_node->fail("material and network exclude each other; remove one of the two");
    }
    if (!material_node && !network_node) {
        root.fail("neither material nor network is given; add `material: {young: ..., density: ...}`");
    }
    std::optional<Material> material;
    if (material_node) {
        material = read_material(*material_node, block);
    }
    const NetworkSettings network =
        material ? calibrated_network(*material, shortest_edge(block)) : read_network(*network_node);
    check_range(material_node ? *material_node : *network_node, network);
    return {material, network};
}

}  // namespace cracksim::scene
