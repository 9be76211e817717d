#include <cstdio>
#include <exception>
#include <new>

#include "core/errors.hpp"
#include "core/float_environment.hpp"
#include "core/standard_streams.hpp"
#include "partition/session.hpp"
#include "simulation/command_line.hpp"
#include "simulation/execute.hpp"

int main(int argc, char** argv) {
    using namespace cracksim;
    flush_subnormals_to_zero();
    guard_standard_streams();
    const partition::Session session{argc, argv};
    const partition::Communicator comm = session.world();
    const auto print = [&](const char* text) {
        if (comm.is_root()) {
            std::fprintf(stderr, "cracksim: %s\n", text);
        }
    };
    // The other ranks do not have this error and would wait forever.
    const auto end_all_ranks = [&](const char* text) {
        std::fprintf(stderr, "cracksim: rank %d: %s\n", comm.rank().value(), text);
        if (comm.size() > 1) {
            partition::Session::abort(1);
        }
        return 1;
    };
    try {
        const auto command = simulation::parse(argc, argv);
        if (const auto* answer = std::get_if<simulation::Answer>(&command)) {
            return simulation::answer(comm, *answer);
        }
        return simulation::execute(comm, std::get<simulation::CommandLine>(command));
    } catch (const InputError& error) {
        print(error.what());
        return 2;
    } catch (const InvalidRun&) {
        return 3;
    } catch (const SharedError& error) {
        print(error.what());
        return 1;
    } catch (const std::bad_alloc&) {
        return end_all_ranks("not enough memory; use fewer block.cells, or more machines");
    } catch (const std::exception& error) {
        return end_all_ranks(error.what());
    }
}
