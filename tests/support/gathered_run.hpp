#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec3.hpp"
#include "partition/communicator.hpp"
#include "physics/events.hpp"

namespace cracksim::test {

struct MassMotion {
    MassId mass;
    Vec3 displacement;  ///< u, m
    Vec3 increment;     ///< w, m
};

/// The result of a scene's run. Events and motions are complete on the root and empty elsewhere.
struct GatheredRun {
    double step_size;  ///< s
    std::int64_t steps;
    std::int64_t unions;                       ///< at the end
    std::vector<physics::DupletEvent> events;  ///< ascending
    std::vector<MassMotion> masses;            ///< at the end, ascending
};

/// Reads the text of a scene and runs it to its end. Collective; throws the exceptions of the reader and of the run.
[[nodiscard]] GatheredRun run_gathered(const partition::Communicator& comm, const std::string& scene_text);

}  // namespace cracksim::test
