#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/dynamics.hpp"
#include "dynamics/stopwatch.hpp"
#include "partition/audit.hpp"
#include "partition/communicator.hpp"
#include "physics/events.hpp"
#include "scene/certified_step.hpp"
#include "scene/scene.hpp"
#include "scene/schedule.hpp"
#include "simulation/books.hpp"
#include "surface/coat.hpp"

namespace cracksim::simulation {

/// Sums over all ranks, for history and progress.
struct Totals {
    std::int64_t inactive_duplets{0};
    std::int64_t splits{0};
    std::int64_t unions{0};
};

/// The events that this rank reports and the splits of its touched unions, since the last coat.
struct FractureEvents {
    std::vector<physics::DupletEvent> events;
    physics::SplitStream splits;
};

class Simulation;

/// Actions at certain steps of a run. All functions are collective and must not change the simulation.
class Observer {
public:
    virtual ~Observer() = default;
    /// Called after each modification of the map.
    virtual void coat(const Simulation&, const FractureEvents&) {}
    virtual void frame(const Simulation&) {}
    virtual void history(const Simulation&) {}
    /// Called every few steps.
    virtual void heartbeat(const Simulation&) {}
};

/// The run loop: physics at every step; topology, frames and history at their rates. The rates do not affect physics.
class Simulation {
public:
    /// Collective. Throws InputError on all ranks alike. comm, scene and stopwatch must outlive this.
    Simulation(const partition::Communicator& comm, const scene::Scene& scene, scene::CertifiedStep certified,
               dynamics::Stopwatch& stopwatch);

    /// From now on each coat is audited: the exchange (partition/audit.hpp), the map and the surface. Collective.
    void enable_audit();

    /// Runs the scene from start to end. Collective. Throws InvalidRun on all ranks.
    void run(Observer& observer);

    [[nodiscard]] const partition::Communicator& comm() const { return *comm_; }
    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }
    [[nodiscard]] const scene::CertifiedStep& certified() const { return certified_; }
    [[nodiscard]] const dynamics::Dynamics& dynamics() const { return dynamics_; }
    [[nodiscard]] const surface::Coat& coat() const { return coat_; }
    [[nodiscard]] dynamics::Stopwatch& stopwatch() const { return *stopwatch_; }
    /// At the last step that was measured: the first, the last or one with due history.
    [[nodiscard]] const Books& books() const { return books_; }
    /// Collective.
    [[nodiscard]] Totals totals() const;

private:
    [[nodiscard]] bool is_measured(std::int64_t step) const;
    void step_actions(Observer& observer, bool forced);
    void check_motion(Observer& observer);
    void modify_coat(Observer& observer);
    void bring_coat_up_to_date(Observer& observer);
    void audit_coat() const;

    const partition::Communicator* comm_;
    const scene::Scene* scene_;
    dynamics::Stopwatch* stopwatch_;
    scene::CertifiedStep certified_;
    dynamics::Dynamics dynamics_;
    surface::Coat coat_;
    std::optional<partition::Audit> audit_;
    scene::Schedule coat_schedule_;
    scene::Schedule frame_schedule_;
    scene::Schedule history_schedule_;
    Books books_;
};

}  // namespace cracksim::simulation
