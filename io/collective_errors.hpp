#pragma once

#include <functional>

#include "partition/communicator.hpp"

namespace cracksim::io {

/// Runs the action on every rank. If it throws on any, all ranks throw one FileError with the text of the lowest rank that failed,
/// so that none goes on to a collective call that the others never reach. Collective.
void all_or_none(const partition::Communicator& comm, const std::function<void()>& action);

/// The same for an action of the root alone. Collective.
void on_root(const partition::Communicator& comm, const std::function<void()>& action);

}  // namespace cracksim::io
