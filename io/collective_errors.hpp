#pragma once

#include <functional>

#include "partition/communicator.hpp"

namespace cracksim::io {

/// Runs the action on every rank. If it throws on any rank, all ranks throw one FileError with the text of the lowest
/// rank that failed, so that no rank enters a collective call that another rank never reaches. Collective.
void all_or_none(const partition::Communicator& comm, const std::function<void()>& action);

/// Like all_or_none(), for an action that only the root runs. Collective.
void on_root(const partition::Communicator& comm, const std::function<void()>& action);

}  // namespace cracksim::io
