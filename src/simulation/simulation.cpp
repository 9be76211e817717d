#include "simulation/simulation.hpp"

#include <limits>
#include <sstream>

#include "core/errors.hpp"
#include "core/text.hpp"

namespace cracksim::simulation {

namespace {

constexpr std::int64_t steps_between_checks = 32;

std::string cause_of(const scene::CertifiedStep& certified, bool finite) {
    std::ostringstream text;
    text << (finite ? "moves by more than 100 edges in a step" : "has a motion that is not a finite number") << "; ";
    if (certified.step > certified.bound.step) {
        text << "likely cause: the time step " << certified.step << " s is above the largest stable step "
             << certified.bound.step << " s; use time.step: auto";
    } else if (finite) {
        text << "the time step is within its bound, so the likely cause is an initial or a support's velocity or "
                "displacement far "
                "above what the material can carry; lower it";
    } else {
        text << "the time step is within its bound, so the likely cause is a support whose velocity is not a number at "
                "that time, "
                "or numbers so large that they overflow";
    }
    return text.str();
}

}  // namespace

Simulation::Simulation(const partition::Communicator& comm, const scene::Scene& scene, scene::CertifiedStep certified,
                       dynamics::Stopwatch& stopwatch)
    : comm_{&comm},
      scene_{&scene},
      stopwatch_{&stopwatch},
      certified_{std::move(certified)},
      dynamics_{comm, scene, certified_.step, stopwatch},
      coat_{comm, dynamics_.network(), dynamics_.decomposition(), dynamics_.state().unions},
      coat_schedule_{scene.coat_rate, certified_.step},
      frame_schedule_{scene.output.rate, certified_.step},
      history_schedule_{scene.history_rate, certified_.step} {}

void Simulation::enable_audit() { audit_.emplace(*comm_, dynamics_.decomposition()); }

bool Simulation::is_measured(std::int64_t step) const {
    return step == 0 || step == certified_.steps || history_schedule_.is_due(step);
}

void Simulation::run(Observer& observer) {
    dynamics_.compute_forces();
    for (;;) {
        const std::int64_t step = dynamics_.state().step;
        const bool measured = is_measured(step);
        if (measured || step % steps_between_checks == 0 || coat_schedule_.is_due(step) ||
            frame_schedule_.is_due(step)) {
            check_motion(observer);
        }
        dynamics_.break_duplets();
        if (measured) {
            books_.record(dynamics::sum(*comm_, dynamics_.balance()));
        }
        step_actions(observer, step == 0 || step == certified_.steps);
        if (step == certified_.steps) {
            return;
        }
        dynamics_.advance(is_measured(step + 1) ? physics::Measure::elastic_energy : physics::Measure::nothing);
    }
}

void Simulation::step_actions(Observer& observer, bool forced) {
    const std::int64_t step = dynamics_.state().step;
    const bool frame_due = forced || frame_schedule_.is_due(step);
    if (frame_due || coat_schedule_.is_due(step)) {
        bring_coat_up_to_date(observer);
    }
    if (forced || history_schedule_.is_due(step)) {
        observer.history(*this);
    }
    if (frame_due) {
        observer.frame(*this);
    }
    if (step % steps_between_checks == 0) {
        observer.heartbeat(*this);
    }
}

void Simulation::modify_coat(Observer& observer) {
    const FractureEvents update{dynamics_.take_events(), dynamics_.take_splits()};
    stopwatch_->time(dynamics::Phase::topology, [&] { coat_.modify(update.splits); });
    observer.coat(*this, update);
}

void Simulation::bring_coat_up_to_date(Observer& observer) {
    if (audit_) {
        dynamics_.audit(*audit_);
    }
    modify_coat(observer);
    if (audit_) {
        audit_coat();
    }
}

void Simulation::audit_coat() const {
    if (const auto fault = coat_.find_fault(dynamics_.state().unions, dynamics_.evolution())) {
        throw SharedError{"audit at step " + std::to_string(dynamics_.state().step) + ": " + *fault};
    }
}

Totals Simulation::totals() const {
    return {comm_->sum(dynamics_.inactive_duplets()), comm_->sum(dynamics_.splits()),
            dynamics_.counts().unions + comm_->sum(dynamics_.parts_gained())};
}

void Simulation::check_motion(Observer& observer) {
    constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
    const auto& failure = dynamics_.failure();
    const std::int64_t step = comm_->min(failure ? failure->step : none);
    if (step == none) {
        return;
    }
    const bool first_here = failure && failure->step == step;
    const std::int64_t mass = comm_->min(first_here ? failure->mass.value() : none);
    const bool finite = !comm_->any(first_here && failure->mass.value() == mass && !failure->finite);
    // Events until this step are written. No frame of the invalid state is written, because ranks may disagree on it.
    modify_coat(observer);
    throw InvalidRun{"the run became invalid at step " + std::to_string(step) +
                         " (t = " + rounded(static_cast<double>(step) * certified_.step, 6) + " s): mass " +
                         std::to_string(mass) + " " + cause_of(certified_, finite),
                     step, MassId{mass}};
}

}  // namespace cracksim::simulation
