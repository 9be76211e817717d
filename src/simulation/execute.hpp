#pragma once

#include "partition/communicator.hpp"
#include "simulation/command_line.hpp"

namespace cracksim::simulation {

/// Prints the text of an answer. Returns the exit code. Collective.
int answer(const partition::Communicator& comm, const Answer& given);

/// Executes a command line: reads the scene, runs it (or forecasts it) and writes its files. Returns the exit code.
/// Throws InputError (exit 2) and InvalidRun (exit 3) on all ranks. Collective.
int execute(const partition::Communicator& comm, const CommandLine& command);

}  // namespace cracksim::simulation
