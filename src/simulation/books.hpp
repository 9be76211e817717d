#pragma once

#include <optional>

#include "dynamics/balance.hpp"

namespace cracksim::simulation {

/// Energies of the block over all ranks, J.
struct Energies {
    double kinetic{0};
    double elastic{0};
    double dissipated{0};  ///< since the start
    double external{0};    ///< work of all supports since the start
    double residual{0};    ///< initial energy + external - (kinetic + elastic + dissipated); 0 if the books close
    /// The energy put in: the initial energy plus, for each support, the magnitudes of its work from one record to the
    /// next.
    double scale{0};
};

/// The books of a run: the energies at the steps that are measured.
class Books {
public:
    /// whole: of all ranks. The first one is the start.
    void record(dynamics::Balance whole);

    /// At the last record.
    [[nodiscard]] const Energies& energies() const { return energies_; }
    [[nodiscard]] const dynamics::Balance& balance() const { return balance_; }

private:
    std::optional<double> initial_;  ///< J
    dynamics::Balance balance_;
    Energies energies_;
};

}  // namespace cracksim::simulation
