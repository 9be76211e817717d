#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/block.hpp"
#include "core/vec3.hpp"
#include "io/expression.hpp"
#include "physics/problem/network.hpp"
#include "physics/problem/sensor_kind.hpp"
#include "physics/problem/stability.hpp"
#include "physics/problem/thresholds.hpp"
#include "physics/state/motion.hpp"
#include "scene/notch_settings.hpp"

namespace cracksim::scene {

/// The entity that a material makes: the standard entity, or the paper's, with 16 interactions.
enum class MaterialModel { standard, paper };

/// Material parameters of an isotropic block.
struct Material {
    MaterialModel model;
    double young;    ///< Pa
    double density;  ///< kg/m3
    double poisson;  ///< 1/4 for the paper's entity
    double damping;  ///< viscosity / stiffness, in units of the shortest edge / sqrt(young/density)
    std::optional<double> fracture_energy;  ///< J/m2
};

/// True for a material of standard entities; false without a material.
[[nodiscard]] inline bool is_standard(const std::optional<Material>& material) {
    return material && material->model == MaterialModel::standard;
}

/// The masses and interactions of every entity.
struct NetworkSettings {
    double mass;  ///< kg at each corner
    physics::KelvinVoigt edge;
    physics::KelvinVoigt diagonal;
};

enum class PartitionKind { metis, slab, random };

struct SensorSettings {
    physics::SensorKind kind;
    io::Expression threshold;   ///< a stretch, as a function of the rest position
    bool from_fracture_energy;  ///< the threshold follows from Material::fracture_energy
    std::optional<physics::Weibull> weibull;
    bool prefilter;  ///< evaluate sensors only at edges that are stretched enough; the triggered duplets are the same
};

struct InitialSettings {
    std::array<io::Expression, 3> displacement;  ///< m, as a function of the rest position
    std::array<io::Expression, 3> velocity;      ///< m/s, as a function of the rest position
};

/// Prescribes the velocity of the masses whose rest position is in the box or on its boundary.
struct SupportSettings {
    std::string name;
    std::array<Vec3, 2> box;  ///< lower and upper corner, m
    std::array<std::optional<io::Expression>, 3>
        velocity;  ///< m/s, as a function of rest position and time; an empty component is free
};

struct Time {
    double end;                  ///< s
    std::optional<double> step;  ///< s; empty: the step follows from the certified bound
    physics::Scheme scheme;
    physics::Precision precision;
    bool allow_unstable;
};

struct Output {
    double rate;  ///< Hz; 0: never
    bool surface;
    bool crack;
    bool masses;
    bool topology;
};

/// Places in the input of values whose errors are found only when the block is built. Each text is the beginning of an
/// error message.
struct Places {
    std::string cells;
    std::string threshold;
    std::string initial;
    std::string supports;
    std::string step;
    std::string end;
    std::string precision;
};

/// The content of an input in SI units, with all defaults filled in. read_scene makes it; it never changes afterwards.
struct Scene {
    std::string title;
    Block block;
    std::optional<Material> material;  ///< determines `network` if the input gives a material
    NetworkSettings network;           ///< of the paper's entity
    physics::DupletKind duplets;
    std::vector<NotchSettings> notches;
    SensorSettings sensors;
    InitialSettings initial;
    std::vector<SupportSettings> supports;
    Time time;
    double coat_rate;  ///< Hz; the rate at which topology and geometry are updated
    Output output;
    double history_rate;  ///< Hz; 0: never
    PartitionKind partition;
    Places places;
    std::vector<std::string> warnings;  ///< for the user: input that is valid but probably a mistake

    [[nodiscard]] bool has_standard_entities() const { return is_standard(material); }
};

[[nodiscard]] inline std::vector<std::string> support_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const SupportSettings& support : scene.supports) {
        names.push_back(support.name);
    }
    return names;
}

}  // namespace cracksim::scene
