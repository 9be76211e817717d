#include "simulation/make_summary.hpp"

#include "core/hash.hpp"
#include "core/text.hpp"
#include "io/memory.hpp"
#include "partition/session.hpp"
#include "physics/simd_target.hpp"
#include "physics/state/hashes.hpp"
#include "scene/resolved.hpp"

namespace cracksim::simulation {

namespace {

constexpr std::size_t listed_fragments = 10;

std::uint64_t digest(const std::string& text) {
    std::uint64_t h = text.size();
    for (const char c : text) {
        h = mix(h, static_cast<unsigned char>(c));
    }
    return h;
}

io::Provenance provenance(const Simulation& simulation) {
    io::Provenance p = io::collect_provenance();
    for (const partition::Library& library : partition::libraries()) {
        p.libraries.emplace_back(library.name, library.version);
    }
    p.simd_target = physics::simd_target_name();
    p.ranks = simulation.comm().size();
    const auto& weibull = simulation.scene().sensors.weibull;
    p.seed = weibull ? weibull->seed : 0;
    p.input_digest = hex(digest(scene::resolved(simulation.scene())));
    return p;
}

io::Summary::Seconds seconds(const Simulation& simulation) {
    const dynamics::Stopwatch& watch = simulation.stopwatch();
    const auto longest = [&](dynamics::Phase phase) { return simulation.comm().max(watch.in(phase)); };
    return {
        simulation.comm().max(watch.total()), longest(dynamics::Phase::setup),    longest(dynamics::Phase::force),
        longest(dynamics::Phase::update),     longest(dynamics::Phase::sense),    longest(dynamics::Phase::exchange),
        longest(dynamics::Phase::topology),   longest(dynamics::Phase::geometry), longest(dynamics::Phase::output)};
}

io::Summary::Memory memory(const Simulation& simulation) {
    const auto entities = static_cast<double>(simulation.scene().block.entity_count());
    const dynamics::Dynamics& dynamics = simulation.dynamics();
    const auto model = static_cast<std::int64_t>(dynamics.memory_bytes());
    const auto coat = static_cast<std::int64_t>(simulation.coat().memory_bytes());
    const auto map = static_cast<std::int64_t>(simulation.coat().map().memory_bytes());
    const partition::Communicator& comm = simulation.comm();
    return {comm.max(io::peak_resident_bytes()), static_cast<double>(comm.sum(model + coat)) / entities,
            static_cast<double>(comm.sum(map)) / entities};
}

io::Summary::Exchange exchange(const Simulation& simulation) {
    const dynamics::MotionExchange& exchange = simulation.dynamics().exchange();
    const std::int64_t steps = std::max<std::int64_t>(1, simulation.dynamics().state().step);
    return {static_cast<double>(simulation.comm().sum(exchange.bytes_sent())) / static_cast<double>(steps),
            simulation.comm().max(std::int64_t{exchange.plan().neighbours()}),
            simulation.comm().max(simulation.stopwatch().in(dynamics::Phase::waiting))};
}

std::vector<io::Summary::Fragment> largest_fragments(const Simulation& simulation) {
    std::vector<io::Summary::Fragment> shares;
    for (const geometry::LabelSize& size : simulation.coat().largest_fragments(listed_fragments)) {
        shares.push_back({size.label, size.volume / simulation.scene().block.volume()});
    }
    return shares;
}

std::vector<io::Summary::Support> supports(const Simulation& simulation) {
    std::vector<io::Summary::Support> all;
    const dynamics::Balance& balance = simulation.books().balance();
    for (std::size_t i = 0; i < balance.work.size(); ++i) {
        const physics::SupportSums& support = balance.unions.supports[i];
        all.push_back(
            {simulation.scene().supports[i].name, support.force, support.mean_displacement(), balance.work[i]});
    }
    return all;
}

}  // namespace

io::Summary summarize(const Simulation& simulation, const forecast::Forecast& forecast,
                      std::vector<io::FrameSeries> frames) {
    const partition::Communicator& comm = simulation.comm();
    const dynamics::Dynamics& dynamics = simulation.dynamics();
    const scene::CertifiedStep& certified = simulation.certified();
    const Totals totals = simulation.totals();
    const Energies& energies = simulation.books().energies();
    io::Summary summary;
    summary.provenance = provenance(simulation);
    summary.counts = simulation.dynamics().counts();
    summary.time = {simulation.scene().time.scheme == physics::Scheme::ab2 ? "ab2" : "cordis",
                    simulation.scene().time.precision == physics::Precision::binary32 ? "single" : "double",
                    certified.step,
                    certified.bound.step,
                    certified.bound.cause,
                    dynamics.state().step,
                    dynamics.state().time()};
    summary.events = {totals.inactive_duplets, totals.splits};
    summary.event_hash = comm.sum(dynamics.event_hash());
    summary.state_hash = comm.sum(physics::state_hash(dynamics.network(), dynamics.state()));
    summary.fragments = simulation.coat().fragment_count();
    summary.components = simulation.coat().component_count();
    summary.largest_fragments = largest_fragments(simulation);
    summary.crack_area = simulation.coat().crack_area();
    summary.energy = {energies.kinetic,  energies.elastic,  energies.dissipated,
                      energies.external, energies.residual, energies.scale};
    summary.momentum = simulation.books().balance().unions.momentum;
    summary.angular_momentum = simulation.books().balance().unions.angular_momentum;
    summary.supports = supports(simulation);
    summary.seconds = seconds(simulation);
    const double running = summary.seconds.total - summary.seconds.setup;
    summary.steps_per_second = static_cast<double>(summary.time.steps) / running;
    summary.times_real_time = summary.time.end / running;
    summary.memory = memory(simulation);
    summary.exchange = exchange(simulation);
    summary.forecast = {forecast.memory_per_rank.intact,   forecast.memory_per_rank.broken,
                        forecast.exchange_per_step.intact, forecast.exchange_per_step.broken,
                        forecast.output.bytes.intact,      forecast.output.bytes.broken,
                        forecast.output.per_face};
    summary.frames = std::move(frames);
    return summary;
}

}  // namespace cracksim::simulation
