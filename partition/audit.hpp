#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/block.hpp"
#include "core/ids.hpp"
#include "partition/communicator.hpp"
#include "partition/decomposition.hpp"
#include "partition/halo.hpp"

namespace cracksim::partition {

/// The union and the motion of a mass as one rank has them.
struct MassView {
    std::int64_t mass_union;    ///< smallest global mass id of its union; -1 if this rank does not advance the union
    std::uint64_t motion_hash;  ///< hash of the bits of its displacement and increments
};

/// Checks the invariants of the distribution during a run. Each check returns a description of an error, the same on
/// all ranks, or nothing if all is well.
class Audit {
public:
    /// Collective.
    Audit(const Communicator& comm, const Decomposition& decomposition);

    /// Collective. Checks that each global mass id that a plan delivers is the requested id, and that none comes twice.
    [[nodiscard]] std::optional<std::string> check_plan(const ExchangePlan& plan) const;

    /// Collective. Checks that each mass of a halo entity has the same motion here and at its owner, and the same union
    /// if both ranks advance it, bit for bit. The values are sent through the plan of the halo entities, not through
    /// the plan that is being checked.
    [[nodiscard]] std::optional<std::string> check_masses(const std::function<MassView(LocalMass)>& view) const;

    /// Collective. reads[m] is the number of times that the force sums of this rank read the force on mass m. Checks
    /// that it is 1 for each mass of a touched union and 0 for every other mass, and that this rank has all masses of
    /// each touched union.
    [[nodiscard]] std::optional<std::string> check_contributions(const Block& block,
                                                                 std::span<const std::int32_t> reads) const;

private:
    const Communicator* comm_;
    const Decomposition* decomposition_;
    Halo halo_;
};

}  // namespace cracksim::partition
