#include "support/gathered_run.hpp"

#include <algorithm>

#include "scene/scene_reader.hpp"
#include "simulation/simulation.hpp"

namespace cracksim::test {

namespace {

class EventCollector : public simulation::Observer {
public:
    void coat(const simulation::Simulation&, const simulation::FractureEvents& update) override {
        events.insert(events.end(), update.events.begin(), update.events.end());
    }

    std::vector<physics::DupletEvent> events;
};

std::vector<MassMotion> owned_motions(const dynamics::Dynamics& dynamics) {
    const physics::Network& network = dynamics.network();
    const physics::State& state = dynamics.state();
    std::vector<MassMotion> motions;
    for (LocalMass m{0}; m.value() < network.mass_count(); ++m) {
        if (network.owned(entity_of(m))) {
            const physics::LocalUnion id = state.unions.union_of(m);
            motions.push_back({network.mass(m), state.displacement(id), state.increment(id)});
        }
    }
    return motions;
}

}  // namespace

GatheredRun run_gathered(const partition::Communicator& comm, const std::string& scene_text) {
    const scene::Scene scene = scene::read_scene(scene_text, "drawn.yaml", {});
    dynamics::Stopwatch stopwatch;
    simulation::Simulation simulation{comm, scene, scene::certify_step(scene), stopwatch};
    EventCollector collector;
    simulation.run(collector);
    GatheredRun run{simulation.certified().step, simulation.certified().steps, simulation.totals().unions,
                    comm.gather<physics::DupletEvent>(collector.events),
                    comm.gather<MassMotion>(owned_motions(simulation.dynamics()))};
    std::ranges::sort(run.events);
    std::ranges::sort(run.masses, {}, &MassMotion::mass);
    return run;
}

}  // namespace cracksim::test
