#include "scene/certified_step.hpp"

#include <cmath>
#include <optional>

#include "core/errors.hpp"
#include "core/text.hpp"
#include "physics/problem/single_precision.hpp"
#include "scene/problem.hpp"

namespace cracksim::scene {

CertifiedStep certify_step(const Scene& scene) {
    const physics::EntityModel model = entity_model(scene);
    const physics::StepBound bound = physics::step_bound(model, scene.time.scheme);
    const double automatic = physics::automatic_step(model, bound);
    const double step = scene.time.step.value_or(automatic);
    constexpr double most_steps = 1e15;
    if (!(scene.time.end / step < most_steps)) {
        throw InputError{scene.places.end + rounded(scene.time.end, 6) + " s takes " +
                         rounded(scene.time.end / step, 6) + " steps of " + rounded(step, 6) +
                         " s, more than can be counted; use an earlier end"};
    }
    if (const auto unfit = scene.time.precision == physics::Precision::binary32
                               ? physics::unfit_for_single_precision(model, step)
                               : std::nullopt) {
        throw InputError{scene.places.precision + "single holds numbers of 1e-25 to 1e25 only, and not " + *unfit +
                         "; use double"};
    }
    CertifiedStep certified{step, bound, static_cast<std::int64_t>(std::ceil(scene.time.end / step * (1 - 1e-12))), ""};
    if (step > bound.step && !scene.time.allow_unstable) {
        throw InputError{scene.places.step + rounded(step, 6) + " s is above the largest stable step " +
                         rounded(bound.step, 6) + " s (set by the " + bound.cause + " of an entity); use at most " +
                         rounded(automatic, 6) + " s or `auto`, or say time.allow_unstable: true"};
    }
    if (step > bound.step) {
        certified.warning = "time.step " + rounded(step, 6) + " s is above the largest stable step " +
                            rounded(bound.step, 6) + " s; the run may blow up (allow_unstable)";
    } else if (step > automatic * (1 + 1e-12)) {
        certified.warning = "time.step " + rounded(step, 6) + " s is stable but closer to the bound " +
                            rounded(bound.step, 6) + " s than the usual " + rounded(automatic, 6) + " s";
    }
    return certified;
}

}  // namespace cracksim::scene
