#include "physics/lattice/next_increments.hpp"

#include <algorithm>
#include <array>

#include "core/contracts.hpp"
#include "physics/lattice/sweep/advance_rows.hpp"
#include "physics/state/prescribed_motion.hpp"

namespace cracksim::physics {

namespace {

/// A whole number of vectors.
constexpr std::size_t unions_at_a_time = 64;
static_assert(unions_at_a_time % Lattice::lanes == 0);

/// Computes the next increments of at most unions_at_a_time unions, without supports.
template <class Real>
void find_some_increments(const State& state, std::span<const ListedUnions::Entry> unions, std::span<double> found) {
    using Components = std::array<Real, 3 * unions_at_a_time>;
    Components increments{};
    Components dt2_over_masses{};
    Components forces{};
    Components next{};
    for (std::size_t i = 0; i < unions.size(); ++i) {
        const LocalUnion s = unions[i].local_union;
        const Vec3 increment = state.increment(s);
        const Vec3 force = state.force(s);
        const double dt2_over_mass = state.dt2_over_mass(s);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
            increments[at] = static_cast<Real>(increment[axis]);
            dt2_over_masses[at] = static_cast<Real>(dt2_over_mass);
            forces[at] = static_cast<Real>(force[axis]);
        }
    }
    find_next_components(NextIncrementView<Real>{increments.data(), dt2_over_masses.data(), forces.data(), next.data(),
                                                 increments.size()});
    std::copy_n(next.cbegin(), found.size(), found.begin());
}

}  // namespace

void find_next_increments(const Network& network, const State& state, std::span<const ListedUnions::Entry> unions,
                          std::span<double> found) {
    CRACKSIM_EXPECT(found.size() == 3 * unions.size());
    for (std::size_t begin = 0; begin < unions.size(); begin += unions_at_a_time) {
        const std::size_t count = std::min(unions_at_a_time, unions.size() - begin);
        const auto some = unions.subspan(begin, count);
        in_precision(state.motion.precision(), [&]<class Real>(Real) {
            find_some_increments<Real>(state, some, found.subspan(3 * begin, 3 * count));
        });
    }
    for (std::size_t i = 0; !state.held.empty() && i < unions.size(); ++i) {
        const std::span<double> next = found.subspan(3 * i, 3);
        const Vec3 held =
            state.motion.rounded(prescribed(network, state, unions[i].local_union, {next[0], next[1], next[2]}, 0.5));
        std::ranges::copy(std::array{held.x, held.y, held.z}, next.begin());
    }
}

}  // namespace cracksim::physics
