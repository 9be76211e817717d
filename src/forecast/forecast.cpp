#include "forecast/forecast.hpp"

#include <algorithm>

#include "core/errors.hpp"
#include "core/text.hpp"
#include "core/vec3.hpp"
#include "forecast/memory_forecast.hpp"
#include "io/memory.hpp"

namespace cracksim::forecast {

namespace {

Range peaks(const scene::Scene& scene, const RankCounts& counts, const RankSetting& setting) {
    return {peak_bytes(scene, counts, setting, 0), peak_bytes(scene, counts, setting, 1)};
}

Range exchange_of(std::int64_t messages, std::int64_t unions, std::int64_t masses) {
    return {dynamics::MotionExchange::bytes_of_step(messages, unions),
            dynamics::MotionExchange::bytes_of_step(messages, masses)};
}

}  // namespace

Machine survey_machine(const partition::Communicator& comm) {
    const std::int64_t here = comm.ranks_on_this_machine();
    const std::int64_t held = io::peak_resident_bytes();
    const auto available = io::available_bytes();
    const std::int64_t room = available ? *available / here + held : 0;
    Machine machine{comm.size(), comm.max(here), comm.max(held), comm.min(io::share_of_memory(here)), std::nullopt};
    if (!comm.any(!available)) {
        machine.room_per_rank = comm.min(room);
    }
    return machine;
}

Forecast estimate(const scene::Scene& scene, const Machine& machine) {
    Forecast forecast;
    forecast.is_partitioned = machine.ranks == 1;
    RankCounts all;
    RankSetting setting{machine.ranks, true, machine.process_bytes};
    for (const RankCounts& counts : estimated_rank_counts(scene.block, scene.partition, machine.ranks)) {
        const Range here = peaks(scene, counts, setting);
        forecast.memory_per_rank = {std::max(forecast.memory_per_rank.intact, here.intact),
                                    std::max(forecast.memory_per_rank.broken, here.broken)};
        all.messages += counts.messages;
        all.sent_unions += counts.sent_unions;
        all.sent += counts.sent;
        setting.is_root = false;
    }
    forecast.exchange_per_step = exchange_of(all.messages, all.sent_unions, all.sent);
    return forecast;
}

Forecast forecast(const partition::Communicator& comm, const scene::Scene& scene, const scene::CertifiedStep& certified,
                  const dynamics::Dynamics& dynamics, const surface::Coat& coat, const Machine& machine) {
    const RankCounts counts = count_rank(dynamics, coat);
    const Range here = peaks(scene, counts, {machine.ranks, comm.is_root(), machine.process_bytes});
    return {dynamics.counts(),
            true,
            {comm.max(here.intact), comm.max(here.broken)},
            exchange_of(comm.sum(counts.messages), comm.sum(counts.sent_unions), comm.sum(counts.sent)),
            forecast_output(scene, certified, dynamics.counts())};
}

void check_memory(const scene::Scene& scene, const Forecast& forecast, const Machine& machine) {
    const std::int64_t need = forecast.memory_per_rank.intact;
    if (need > machine.memory_per_rank) {
        throw InputError{scene.places.cells + std::to_string(scene.block.entity_count()) + " entities need about " +
                         bytes_text(static_cast<double>(need)) + " a rank, and a rank can have " +
                         bytes_text(static_cast<double>(machine.memory_per_rank)) +
                         " of its machine's memory; use fewer cells, or more machines"};
    }
}

std::optional<std::string> memory_warning(const Forecast& forecast, const Machine& machine) {
    const Range& need = forecast.memory_per_rank;
    if (!machine.room_per_rank || need.broken <= *machine.room_per_rank) {
        return std::nullopt;
    }
    const bool always = need.intact > *machine.room_per_rank;
    const auto text = [&](std::int64_t per_rank) {
        return bytes_text(static_cast<double>(per_rank)) + " a rank, " +
               bytes_text(static_cast<double>(per_rank * machine.ranks_here)) + " for the " +
               std::to_string(machine.ranks_here) + " rank(s) of a machine";
    };
    return std::string{"memory: the run needs about "} + text(always ? need.intact : need.broken) +
           (always ? "" : " if all of it breaks") + ", and there are " +
           bytes_text(static_cast<double>(*machine.room_per_rank * machine.ranks_here)) +
           "; without more, the system will kill it: use ranks on more machines, or fewer entities";
}

}  // namespace cracksim::forecast
