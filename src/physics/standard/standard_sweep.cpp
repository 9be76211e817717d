#include "physics/standard/standard_sweep.hpp"

#include <algorithm>

#include "core/contracts.hpp"
#include "physics/lattice/views.hpp"
#include "physics/standard/sweep/standard_row.hpp"

namespace cracksim::physics {

namespace {

template <class Real>
void set_hourglass(const StandardEntity& entity, double zeta, StandardConstants<Real>& k) {
    const auto real = [](double value) { return static_cast<Real>(value / 32); };
    for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t i = 0; i < 3; ++i) {
            k.hourglass[p][i] = real(entity.bending[i] - entity.isotropic[p]);
            k.hourglass_damping[p][i] = real(zeta * entity.bending[i]);
        }
        k.coupling[p] = real(entity.coupling[p]);
        k.coupling_damping[p] = real(zeta * entity.coupling[p]);
        k.hourglass_damping[3][p] = real(zeta * entity.isotropic[3]);
        const double own = entity.warping ? (*entity.warping)[p][p] : entity.isotropic[p];
        k.hourglass[p][p] = real(own - entity.isotropic[p]);
        k.hourglass_damping[p][p] = real(zeta * own);
        const double other = entity.warping ? (*entity.warping)[(p + 1) % 3][(p + 2) % 3] : 0;
        k.warping[p] = real(other);
        k.warping_damping[p] = real(zeta * other);
    }
}

template <class Real>
StandardConstants<Real> constants(const StandardEntity& entity, double dt) {
    const auto real = [](double value) { return static_cast<Real>(value); };
    const double zeta = entity.solid.damping_time / dt;
    StandardConstants<Real> k{};
    for (std::size_t i = 0; i < 3; ++i) {
        k.alpha[i] = real(1 / (4 * entity.edge[static_cast<int>(i)]));
    }
    for (std::size_t p = 0; p < 4; ++p) {
        k.weight[p] = real(entity.bound_weight[p] / 64);
        k.isotropic[p] = real(entity.isotropic[p] / 32);
    }
    k.bulk = real(1.5 * entity.bulk * entity.volume);
    k.bulk_damping = real(4 * entity.bulk * entity.volume * zeta);
    k.shear = real(0.5 * entity.shear * entity.volume);
    k.deviator = real(9 * entity.shear * entity.volume);
    k.damping = real(zeta);
    k.inverse_modulus = real(1 / (entity.solid.young * entity.volume));
    set_hourglass(entity, zeta, k);
    return k;
}

template <class Real>
StandardView<Real> inputs_of(const Network& network, const State& state) {
    const StandardEntity& entity = network.model().standard();
    StandardView<Real> v{};
    v.constants = constants<Real>(entity, state.step_size);
    v.is_cube = !entity.warping;
    v.is_damped = entity.solid.damping_time > 0;
    return v;
}

template <class Real>
StandardView<Real> view_of(const Network& network, State& state, StandardCaches& caches) {
    StandardView<Real> v = inputs_of<Real>(network, state);
    set_motion(state, caches.rows, v);
    v.present = caches.present.data();
    v.owned = caches.owned.data();
    v.limits = caches.limits.data();
    v.stretched = caches.stretched.data();
    v.stored = caches.stresses.stored();
    v.stresses = caches.stresses.by_batch();
    return v;
}

template <class Real>
void find_forces(const Network& network, const State& state, std::span<const LocalEntity> entities,
                 std::span<CornerForces> found) {
    GatheredEntities<Real> gathered = gather<Real>(state, entities);
    sweep_standard_entities(inputs_of<Real>(network, state), gathered);
    take_forces(gathered, found);
}

}  // namespace

StandardSweep standard_sweep(const Network& network, State& state, StandardCaches& caches, Measure measure) {
    return in_precision(state.motion.precision(), [&]<class Real>(Real) {
        return StandardSweep{state.lattice(), view_of<Real>(network, state, caches), measure};
    });
}

void find_standard_corner_forces(const Network& network, const State& state, std::span<const LocalEntity> entities,
                                 std::span<CornerForces> found) {
    CRACKSIM_EXPECT(entities.size() <= Lattice::lanes && found.size() == entities.size());
    in_precision(state.motion.precision(),
                 [&]<class Real>(Real) { find_forces<Real>(network, state, entities, found); });
}

std::vector<SymmetricTensor> find_standard_stresses(const Network& network, const State& state,
                                                    std::span<const LocalEntity> entities) {
    std::vector<SymmetricTensor> found(entities.size());
    for (std::size_t first = 0; first < entities.size(); first += Lattice::lanes) {
        const auto some = entities.subspan(first, std::min<std::size_t>(Lattice::lanes, entities.size() - first));
        BatchStress stresses;
        in_precision(state.motion.precision(), [&]<class Real>(Real) {
            find_standard_stresses(inputs_of<Real>(network, state), gather<Real>(state, some), stresses);
        });
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            found[first + lane] = stresses.of(lane);
        }
    }
    return found;
}

}  // namespace cracksim::physics
