#include "forecast/memory_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "core/hexahedron.hpp"
#include "io/frame_writer.hpp"
#include "physics/lattice/loaded_faces.hpp"
#include "physics/lattice/stretched_sensors.hpp"
#include "physics/problem/network.hpp"
#include "physics/state/state.hpp"
#include "scene/counts.hpp"
#include "surface/local_surface.hpp"
#include "surface/mesh_assembly.hpp"
#include "surface/surface_frames.hpp"
#include "surface/surface_update.hpp"
#include "topology/connectivity/spanning_forest.hpp"
#include "topology/face_link.hpp"

namespace cracksim::forecast {

namespace {

// These constants are measured; everything else follows from the sizes of the stored types.

/// Memory that libraries (HDF5, MPI, code pages) take at their first use, in addition to the block.
constexpr double libraries_in_use = 6e6;
/// Lower limits of the peak above process_bytes, for blocks too small to leave reusable memory for the libraries and
/// the worker thread. Measured: peaks of runs of 1 to 224 entities, 10.0 to 11.2 MB on 1, 2 and 4 ranks; without the
/// thread, 0.6 MB less on another machine.
constexpr Range least_in_use{8'900'000, 12'000'000};
/// Bytes for each entity of the whole block, on the root: the graph and METIS's coarser graphs. Measured at the peak of
/// 800,000 entities on 8 ranks.
constexpr double metis_per_entity = 180;
/// Bytes for each sent or received mass in addition to the data of MotionExchange: ids, PetscSF's lists and buffers.
constexpr double exchange_per_mass = 45;

constexpr double duplets = physics::duplets_per_face;

double number(std::int64_t n) { return static_cast<double>(n); }
double between(const Range& range, double opened) {
    return number(range.intact) + opened * number(range.broken - range.intact);
}

double number_bytes(const scene::Time& time) {
    return time.precision == physics::Precision::binary32 ? sizeof(float) : sizeof(double);
}

double masses(const RankCounts& counts) { return Hexahedron::corners * number(counts.local); }

/// Also true with Weibull factors if the threshold is infinite, because a factor does not change it.
bool has_one_threshold(const scene::SensorSettings& sensors) {
    return sensors.threshold.is_constant() && (!sensors.weibull || std::isinf(sensors.threshold({}, 0)));
}

/// The network without the lattice; state_bytes() includes the lattice.
double network_bytes(const RankCounts& counts, const scene::SensorSettings& sensors) {
    constexpr double per_entity = sizeof(EntityId) + sizeof(std::uint8_t) + Hexahedron::faces * sizeof(std::int32_t);
    const double sensors_of_face = sensors.kind == physics::SensorKind::stress ? 1 : duplets;
    const double thresholds = has_one_threshold(sensors) ? 0 : sensors_of_face * sizeof(double);
    const double per_face = sizeof(physics::InteriorFace) + thresholds + sizeof(std::uint8_t);
    return number(counts.local) * per_entity + number(counts.interior_faces) * per_face +
           number(counts.received) * (sizeof(LocalMass) + sizeof(std::size_t) + sizeof(physics::ReceivedUnions::Entry));
}

/// Arrays that grow with the splits get an eighth of spare capacity; on average half of it is unused.
constexpr double with_room = 1 + 1.0 / 16;

/// The state, with the void sites of the rows; the base layer has a place for every vertex site.
double state_bytes(const RankCounts& counts, const scene::Time& time) {
    constexpr double lanes = physics::Lattice::lanes;
    constexpr double per_entity = Hexahedron::corners * sizeof(std::uint8_t) + sizeof(std::int32_t);
    constexpr double limits = physics::HexahedronPairs::edges * lanes * sizeof(physics::Bfloat16);
    constexpr double per_batch = physics::SharedEdges::bytes_per_batch + limits + sizeof(physics::EdgeBits) +
                                 2 * (sizeof(std::uint32_t) + sizeof(std::int32_t)) + sizeof(std::int32_t);
    constexpr double per_site = sizeof(LocalEntity) + per_batch / lanes;
    constexpr double per_vertex = sizeof(std::uint8_t) + physics::StretchedSensors::bytes_per_vertex() +
                                  sizeof(std::int32_t) + 2 * sizeof(std::int32_t) / lanes;
    const double components = time.scheme == physics::Scheme::ab2 ? 13 : 10;
    return number(counts.local) * per_entity + number(counts.sites) * per_site +
           number(counts.vertex_sites) * (per_vertex + components * number_bytes(time)) + number(counts.interior_faces);
}

/// Motions of unions outside the base layer.
double pooled_motion_bytes(const RankCounts& counts, const scene::Time& time, double opened) {
    const double components = physics::Pooled::together * (time.scheme == physics::Scheme::ab2 ? 4 : 3);
    const double unions = masses(counts) * (physics::layers - 1) / physics::layers;
    return opened * unions * with_room * (components * number_bytes(time) + sizeof(physics::PoolPlace));
}

/// Motions of unions outside the base layer and their indexes by vertex and by entity.
double pool_bytes(const RankCounts& counts, const scene::Time& time, double opened) {
    constexpr double per_vertex = with_room * physics::layers * sizeof(physics::PoolPlace);
    constexpr double per_site = with_room * sizeof(physics::PooledCorners) / physics::Lattice::half;
    const double lists = number(counts.vertex_sites) * per_vertex + number(counts.sites) * per_site;
    return pooled_motion_bytes(counts, time, opened) + opened * lists;
}

/// Temporary memory while all faces open at once: the sensors at their edges, and a second copy of the pool while it is
/// reordered.
double breaking_bytes(const RankCounts& counts, const scene::Time& time, double opened) {
    return opened * number(counts.interior_faces) * with_room * physics::StretchedSensors::bytes_per_face() +
           pooled_motion_bytes(counts, time, opened);
}

/// The coat: links, sewn masks, unions by mass, the search for replacement edges, two spanning forests (components and
/// fragments), and the free faces with their index.
double coat_bytes(const RankCounts& counts, double opened) {
    constexpr double search = sizeof(LocalEntity) + sizeof(std::int32_t);
    constexpr double per_entity = Hexahedron::faces * sizeof(topology::FaceLink) + sizeof(std::uint8_t) +
                                  Hexahedron::corners * sizeof(LocalMass) + search +
                                  2 * (sizeof(LocalEntity) + sizeof(topology::Tree)) + sizeof(std::int32_t) +
                                  sizeof(std::uint8_t);
    const double free_faces = number(counts.boundary_faces) + 2 * opened * number(counts.interior_faces);
    return number(counts.local) * per_entity +
           free_faces * (sizeof(surface::LocalSurface::Face) + sizeof(std::int32_t));
}

double distribution_bytes(const RankCounts& counts) {
    constexpr double per_entity = sizeof(EntityId) + sizeof(Rank) + sizeof(std::uint8_t);
    constexpr double per_mass =
        exchange_per_mass + dynamics::MotionExchange::longest_per_mass + physics::ListedUnions::bytes_per_mass;
    return number(counts.local) * per_entity + number(counts.received + counts.sent) * per_mass +
           number(counts.received) * sizeof(Vec3);
}

/// The partition, before anything else is built: the owner of every entity of the block, a mark for each, and on the
/// root the memory of METIS.
double partition_bytes(const scene::Scene& scene, const RankSetting& setting) {
    const bool by_metis = setting.is_root && setting.ranks > 1 && scene.partition == scene::PartitionKind::metis;
    return number(scene.block.entity_count()) *
           (sizeof(Rank) + sizeof(std::uint8_t) + (by_metis ? metis_per_entity : 0.0));
}

/// The numbers of cells of a frame that a rank makes from its own entities, and that it files by their ids (see
/// mesh_assembly.cpp). The first range of ids contains the lower side of the block, so its rank files most.
struct Share {
    double made;
    double filed;
};

Share share_of(const scene::Scene& scene, const SeriesForecast& series, const RankCounts& counts, int ranks,
               double opened) {
    const Block& block = scene.block;
    const double all = number(block.entity_count());
    const double boundary = Hexahedron::faces * all - 2 * number(block.interior_face_count());
    const bool begins_as_boundary =
        number(series.faces.intact) == boundary && series.faces.broken > series.faces.intact;
    const double inside = opened * number(series.faces.broken - series.faces.intact);
    if (!begins_as_boundary) {
        const double cells = number(series.faces.intact) + inside;
        return {cells * number(counts.owned) / all, cells / ranks};
    }
    const double lower = number(block.cells()[0] * block.cells()[1]);
    const double first = ranks == 1 ? boundary : std::min(lower, all / ranks) + (boundary - 2 * lower) / ranks;
    return {number(counts.boundary_faces) + inside * number(counts.owned) / all, first + inside / ranks};
}

/// The peak of the assembly of a mesh. The records of points (or of cells) exist three times on the sending side (as
/// made, divided by rank, and concatenated for the message) and twice on the receiving side (as received, and divided
/// by rank), in addition to the records of cells (or of points).
double assembly_bytes(const Share& cells, double corners) {
    const double cell = sizeof(surface::CellRecord);
    const double point = corners * sizeof(surface::PointRecord);
    const double while_points = (3 * point + cell) * cells.made + 2 * point * cells.filed;
    const double while_cells = (point + 3 * cell) * cells.made + (point + 2 * cell) * cells.filed;
    return std::max(while_points, while_cells);
}

/// Small frames are gathered: the root holds the whole frame, and one of its arrays (a value for each corner of a cell)
/// twice.
double gathering_bytes(const SeriesForecast& series, const RankSetting& setting, double cells, double frame) {
    const bool gathered = setting.is_root && frame < number(io::FrameWriter::default_gather_below);
    const double share = frame / setting.ranks;
    return gathered ? share + frame + number(series.cells.corners()) * cells * sizeof(std::int64_t) : share;
}

bool is_kept(const SeriesForecast& series, double cells) {
    const bool is_surface = series.name == "surface" || series.name == "crack";
    return is_surface && surface::SurfaceFrames::fit(series.cells, std::llround(cells));
}

/// The memory of a surface that is kept between frames. Each rank holds its points and its update, as lists and packed.
/// The root also holds the updates of all ranks, as lists and packed, and the gathered surface with its keys, its order
/// and the crack mesh.
double keeping_bytes(const SeriesForecast& series, const RankSetting& setting, double made, double opened) {
    constexpr double cell_sent = sizeof(surface::SurfaceUpdate::Face) + sizeof(EntityId);
    constexpr double point_sent = sizeof(MassId) + sizeof(Vec3);
    constexpr double cell_kept = sizeof(std::int64_t) + sizeof(std::int32_t);
    const double cells = between(series.faces, opened);
    const double points_a_cell = between(series.points, opened) / std::max(1.0, cells);
    const double crack = (cells - number(series.faces.intact)) / std::max(1.0, cells);
    const auto sent = [&](double faces) { return 2 * faces * (cell_sent + points_a_cell * point_sent); };
    const double here = sent(made) + made * points_a_cell * (sizeof(LocalMass) + sizeof(Vec3));
    const double meshes = (1 + crack) * between(series.frame_bytes, opened);
    const double whole = sent(cells) + meshes + cells * (1 + points_a_cell) * cell_kept;
    return here + (setting.is_root ? whole : 0);
}

/// The memory of the series that takes most.
double frame_bytes(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting, double opened) {
    double most = 0;
    for (const SeriesForecast& series : forecast_series(scene, scene::count_without_notches(scene))) {
        const double cells = between(series.faces, opened);
        const double frame = between(series.frame_bytes, opened);
        const Share share = share_of(scene, series, counts, setting.ranks, opened);
        const double taken = is_kept(series, cells) ? keeping_bytes(series, setting, share.made, opened)
                                                    : std::max(assembly_bytes(share, number(series.cells.corners())),
                                                               gathering_bytes(series, setting, cells, frame));
        most = std::max(most, taken);
    }
    return most;
}

/// The events of a coat: on each rank its own events; on the root the events of all ranks, as gathered, as sorted, and
/// as columns of the file.
double event_bytes(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting, double opened) {
    constexpr double event = sizeof(physics::DupletEvent);
    constexpr double part = 3 * sizeof(std::int64_t);
    constexpr double stream = sizeof(std::size_t) + sizeof(LocalMass);
    const auto held = [&](double entities, double interior_faces, double copies) {
        const double each_mass = Hexahedron::corners * entities * (part + sizeof(MassId));
        return copies * (interior_faces * duplets * event + each_mass);
    };
    const double here = held(number(counts.owned), number(counts.interior_faces), 1) + masses(counts) * stream;
    constexpr double columns = 4 * sizeof(std::int64_t);
    const double all_interior_faces = number(scene.block.interior_face_count());
    const double on_root =
        held(number(scene.block.entity_count()), all_interior_faces, 2) + all_interior_faces * duplets * columns;
    return opened * (here + (setting.is_root ? on_root : 0));
}

/// The share of the interior faces that are open if the share `broken` of them breaks: at least the notched ones.
double share_opened(const RankCounts& counts, double broken) {
    return std::max(broken, number(counts.notched_faces) / std::max(1.0, number(counts.interior_faces)));
}

}  // namespace

double model_bytes(const scene::Scene& scene, const RankCounts& counts, double broken) {
    const double opened = share_opened(counts, broken);
    const bool by_stress = scene.sensors.kind == physics::SensorKind::stress;
    const double bounds = by_stress ? number(counts.sites) * physics::LoadedFaces::bytes_per_site() : 0;
    return network_bytes(counts, scene.sensors) + state_bytes(counts, scene.time) + bounds +
           pool_bytes(counts, scene.time, opened) + coat_bytes(counts, opened);
}

std::int64_t peak_bytes(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting,
                        double broken) {
    const double opened = share_opened(counts, broken);
    const double model = model_bytes(scene, counts, broken) + distribution_bytes(counts);
    // Events and frames add up: SuperLU_DIST, a dependency of PETSc, sets the allocator to return no memory to the
    // system, and the blocks of memory that a coat frees are too small for a frame.
    const double running = model + breaking_bytes(counts, scene.time, opened) +
                           event_bytes(scene, counts, setting, opened) + frame_bytes(scene, counts, setting, opened);
    const double phases = libraries_in_use + std::max(partition_bytes(scene, setting), running);
    return setting.process_bytes + std::llround(std::max(phases, between(least_in_use, opened)));
}

}  // namespace cracksim::forecast
