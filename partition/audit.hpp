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

/// A mass as one rank sees it.
struct MassView {
    std::int64_t
        mass_union;  ///< smallest global mass id of its union; -1 where this rank does not know (received masses)
    std::uint64_t motion_hash;  ///< of the bits of its displacement and increments
};

/// Proves, while a run goes on, what the distribution promises. Findings come as text, the same on all ranks; none: all is well.
class Audit {
public:
    /// Collective.
    Audit(const Communicator& comm, const Decomposition& decomposition);

    /// Collective. Each global mass id that a plan delivers is the id that was asked for, and each comes once.
    [[nodiscard]] std::optional<std::string> check_plan(const ExchangePlan& plan) const;

    /// Collective. Every mass of a halo entity has here and at its owner the same motion and, where both know it, the same
    /// union, bit for bit. It travels by the table of halo entities, not by the plan that it checks.
    [[nodiscard]] std::optional<std::string> check_masses(const std::function<MassView(LocalMass)>& view) const;

    /// Collective. reads[m] is how often the sums that this rank advances read the force on mass m: once for each mass of a
    /// touched union, never for another. And all the masses of each touched union are here.
    [[nodiscard]] std::optional<std::string> check_contributions(const Block& block,
                                                                 std::span<const std::int32_t> reads) const;

private:
    const Communicator* comm_;
    const Decomposition* decomposition_;
    Halo halo_;
};

}  // namespace cracksim::partition
