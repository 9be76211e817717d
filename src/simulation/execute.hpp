#pragma once

#include "partition/communicator.hpp"
#include "simulation/command_line.hpp"

namespace cracksim::simulation {

/// Tells what the command line asks for. Returns the exit code. Collective.
int answer(const partition::Communicator& comm, const Answer& given);

/// Does what the command line says: reads the scene, runs it (or forecasts it) and writes its files. Returns the exit
/// code; throws InputError (exit 2) and InvalidRun (exit 3) on all ranks alike. Collective.
int execute(const partition::Communicator& comm, const CommandLine& command);

}  // namespace cracksim::simulation
