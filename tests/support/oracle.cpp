#include "support/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "support/oracle_block.hpp"
#include "support/oracle_standard.hpp"
#include "support/oracle_stress.hpp"

namespace cracksim::oracle {

namespace {

Vector evaluate(const std::array<Field, 3>& field, const Vector& at) {
    return {field[0](at, 0), field[1](at, 0), field[2](at, 0)};
}

class Run {
public:
    explicit Run(const Scene& scene)
        : scene_{scene}, duplets_{duplets(scene)}, active_(duplets_.size(), true), union_(mass_count(scene)) {
        for (std::size_t m = 0; m < mass_count(scene); ++m) {
            rest_.push_back(rest_position(scene, m));
            u_.push_back(evaluate(scene.displacement, rest_[m]));
        }
        if (scene.standard) {
            hourglass_ = find_hourglass(*scene.standard, scene.edge);
        }
        for (const Duplet& duplet : duplets_) {
            threshold_.push_back(threshold(scene, duplet));
        }
        find_unions();
        outcome_.starting_unions = count_unions();
        start();
    }

    void sense() {
        if (scene_.sensors == Sensors::stress) {
            loads_ = face_loads(scene_, u_);
        }
        for (std::size_t d = 0; d < duplets_.size(); ++d) {
            if (active_[d]) {
                decide(d);
            }
        }
        find_unions();
    }

    void advance() {
        const double dt = scene_.step;
        std::vector<Vector> velocity;
        for (std::size_t m = 0; m < u_.size(); ++m) {
            const bool ab2 = scene_.scheme == Scheme::ab2;
            velocity.push_back(plus(plus({}, (ab2 ? 1.5 : 1) / dt, w_[m]), (ab2 ? -0.5 : 0) / dt, w_before_[m]));
        }
        const std::vector<Vector> acceleration = accelerations(velocity);
        const double middle = (static_cast<double>(step_) + 0.5) * dt;
        w_before_ = w_;
        for (std::size_t m = 0; m < u_.size(); ++m) {
            w_[m] = hold(m, plus(w_before_[m], dt * dt, acceleration[m]), middle);
            u_[m] = plus(u_[m], 1, w_[m]);
        }
        ++step_;
    }

    [[nodiscard]] Outcome outcome() {
        outcome_.displacement = u_;
        outcome_.increment = w_;
        outcome_.unions = count_unions();
        return outcome_;
    }

private:
    /// w(0) = dt v - dt^2 a/2, w(-1) = dt v - 3 dt^2 a/2. The masses of a union rest at one place, so their velocities
    /// are equal. With ab2, v is the velocity of the supports where they hold.
    void start() {
        const double dt = scene_.step;
        std::vector<Vector> velocity;
        for (std::size_t m = 0; m < u_.size(); ++m) {
            const Vector free = evaluate(scene_.velocity, rest_[m]);
            velocity.push_back(scene_.scheme == Scheme::ab2 ? plus({}, 1 / dt, hold(m, plus({}, dt, free), 0)) : free);
        }
        const std::vector<Vector> acceleration = accelerations(velocity);
        for (std::size_t m = 0; m < u_.size(); ++m) {
            const Vector drift = plus({}, dt, velocity[m]);
            w_.push_back(hold(m, plus(drift, -0.5 * dt * dt, acceleration[m]), -0.5 * dt));
            w_before_.push_back(hold(m, plus(drift, -1.5 * dt * dt, acceleration[m]), -1.5 * dt));
        }
    }

    /// A duplet's sensor measures the distance of P and Q, the masses one edge off the shared face on either side.
    [[nodiscard]] double stretch(const Duplet& duplet) const {
        const auto& [a, b, axis] = duplet;
        const double rest = 2 * scene_.edge[axis];
        Vector distance = plus(u_[across(b, axis)], -1, u_[across(a, axis)]);
        distance[axis] += rest;
        return length(distance) / rest - 1;
    }

    void decide(std::size_t d) {
        const auto& [a, b, axis] = duplets_[d];
        const double measured =
            scene_.sensors == Sensors::stress ? loads_[3 * (a / corners) + axis] : stretch(duplets_[d]);
        const Decision decision{step_, a, b, std::abs(measured / threshold_[d] - 1)};
        outcome_.smallest_margin = std::min(outcome_.smallest_margin, decision.margin);
        if (measured > threshold_[d]) {
            active_[d] = false;
            outcome_.events.push_back(decision);
        } else if (decision.margin < 1e-8) {
            outcome_.near_events.push_back(decision);
        }
    }

    /// Finds the unions: the smallest mass of each spreads over active duplets until nothing changes.
    void find_unions() {
        std::iota(union_.begin(), union_.end(), std::size_t{0});
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t d = 0; d < duplets_.size(); ++d) {
                std::size_t& a = union_[duplets_[d].a];
                std::size_t& b = union_[duplets_[d].b];
                if (active_[d] && a != b) {
                    a = b = std::min(a, b);
                    changed = true;
                }
            }
        }
    }

    [[nodiscard]] std::size_t count_unions() const {
        std::size_t count = 0;
        for (std::size_t m = 0; m < union_.size(); ++m) {
            count += union_[m] == m ? 1U : 0U;
        }
        return count;
    }

    /// An edge joins corners that differ along one axis, a diagonal those that differ along all three axes.
    void interact(std::size_t i, std::size_t j, const std::vector<Vector>& velocity) {
        Vector rest{};
        int differing = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t from = corner_place[i % corners][axis];
            const std::size_t to = corner_place[j % corners][axis];
            rest[axis] = (static_cast<double>(to) - static_cast<double>(from)) * scene_.edge[axis];
            differing += from != to ? 1 : 0;
        }
        if (differing == 2) {
            return;
        }
        const auto& [k, z] = differing == 1 ? scene_.edges : scene_.diagonals;
        const Vector d = plus(rest, 1, plus(u_[j], -1, u_[i]));
        const Vector n = plus({}, 1 / length(d), d);
        const double tension = k * (length(d) - length(rest)) + z * dot(plus(velocity[j], -1, velocity[i]), n);
        force_[i] = plus(force_[i], tension, n);
        force_[j] = plus(force_[j], -tension, n);
    }

    /// The force on each mass's union divided by the mass of that union, by mass.
    [[nodiscard]] std::vector<Vector> accelerations(const std::vector<Vector>& velocity) {
        force_.assign(u_.size(), {});
        for (std::size_t i = 0; i < u_.size(); ++i) {
            for (std::size_t j = i + 1; !scene_.standard && j / corners == i / corners; ++j) {
                interact(i, j, velocity);
            }
        }
        for (std::size_t e = 0; scene_.standard && e < entity_count(scene_); ++e) {
            const CornerVectors force =
                standard_forces(*scene_.standard, *hourglass_, scene_.edge, of_entity(u_, e), of_entity(velocity, e));
            std::ranges::copy(force, force_.begin() + static_cast<std::ptrdiff_t>(corners * e));
        }
        std::vector<Vector> force(u_.size());
        std::vector<double> mass(u_.size());
        for (std::size_t m = 0; m < u_.size(); ++m) {
            force[union_[m]] = plus(force[union_[m]], 1, force_[m]);
            mass[union_[m]] += scene_.mass;
        }
        std::vector<Vector> all;
        for (std::size_t m = 0; m < u_.size(); ++m) {
            all.push_back(plus({}, 1 / mass[union_[m]], force[union_[m]]));
        }
        return all;
    }

    /// Replaces the held components of an increment by their prescribed values at `time`. Before 0, the velocity is
    /// extrapolated linearly: v(-t) = 2 v(0) - v(t).
    [[nodiscard]] Vector hold(std::size_t mass, Vector increment, double time) const {
        const Vector& at = rest_[mass];
        for (const Support& support : scene_.supports) {
            bool inside = true;
            for (std::size_t i = 0; i < 3; ++i) {
                inside = inside && support.lower[i] <= at[i] && at[i] <= support.upper[i];
            }
            for (std::size_t i = 0; i < 3; ++i) {
                if (const Field& v = support.velocity[i]; inside && v) {
                    increment[i] = scene_.step * (time >= 0 ? v(at, time) : 2 * v(at, 0) - v(at, -time));
                }
            }
        }
        return increment;
    }

    const Scene& scene_;
    std::vector<Duplet> duplets_;
    std::optional<Hourglass> hourglass_;  ///< of standard entities
    std::vector<double> threshold_;       ///< by duplet
    std::vector<double> loads_;           ///< of the faces, at the current step
    std::vector<bool> active_;            ///< by duplet
    std::vector<std::size_t> union_;      ///< by mass: the smallest mass of its union
    std::vector<Vector> rest_, u_, w_, w_before_, force_;
    std::int64_t step_{0};
    Outcome outcome_{{}, {}, std::numeric_limits<double>::infinity(), {}, {}, 0, 0};
};

}  // namespace

Outcome run(const Scene& scene) {
    Run run{scene};
    for (std::int64_t step = 0;; ++step) {
        run.sense();
        if (step == scene.steps) {
            return run.outcome();
        }
        run.advance();
    }
}

}  // namespace cracksim::oracle
