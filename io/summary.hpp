#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "core/problem_counts.hpp"
#include "core/vec3.hpp"
#include "io/frame_record.hpp"
#include "io/provenance.hpp"

namespace cracksim::io {

enum class Status { finished, stopped, invalid };

/// The contents of summary.json; each member has the name and meaning of a key. SI units.
struct Summary {
    /// Why a run is invalid.
    struct Invalid {
        std::int64_t step;
        MassId mass;
        std::string cause;
    };
    struct Time {
        std::string scheme;
        std::string precision;
        double step{0};   ///< s
        double bound{0};  ///< the largest stable step, s
        std::string bound_cause;
        std::int64_t steps{0};
        double end{0};  ///< s
    };
    struct Events {
        std::int64_t duplets{0}, splits{0};
    };
    /// A fragment's id is its smallest entity id; its share is of the block's rest volume, 0 to 1.
    struct Fragment {
        EntityId id;
        double volume_share;
    };
    struct Energy {  ///< J; residual = initial + external - (kinetic + elastic + dissipated), scale: the energy put in
        double kinetic{0}, elastic{0}, dissipated{0}, external{0}, residual{0}, scale{0};
    };
    struct Support {
        std::string name;
        Vec3 force;         ///< on the block, N
        Vec3 displacement;  ///< mean of the masses that it holds, m
        double work{0};     ///< on the block, J
    };
    struct Seconds {
        double total{0}, setup{0}, force{0}, update{0}, sense{0}, exchange{0}, topology{0}, geometry{0}, output{0};
    };
    struct Memory {  ///< bytes
        std::int64_t per_rank_max{0};
        double per_entity{0}, map_per_entity{0};
    };
    struct Exchange {
        double bytes_per_step{0};  ///< of all ranks together, on average
        std::int64_t neighbours_max{0};
        double waiting{0};  ///< time that ranks wait for messages of other ranks, s; a part of seconds.exchange
    };
    /// Forecast made before the first step, bytes: intact if nothing breaks, broken if everything breaks in the first
    /// step.
    struct Forecast {
        std::int64_t memory_intact{0}, memory_broken{0};      ///< of the rank with the most memory
        std::int64_t exchange_intact{0}, exchange_broken{0};  ///< of all ranks together, per step
        std::int64_t output_intact{0}, output_broken{0};
        std::int64_t output_per_interface{0};  ///< per interior face that opens and per later frame
    };

    Status status{Status::finished};
    std::optional<Invalid> invalid;    ///< given if, and only if, status is invalid
    std::optional<std::string> error;  ///< why the run stopped; given if, and only if, status is stopped
    bool bitwise{true};
    Provenance provenance;
    ProblemCounts counts;
    Time time;
    Events events;
    std::uint64_t event_hash{0}, state_hash{0};
    std::int64_t fragments{0}, components{0};
    std::vector<Fragment> largest_fragments;
    double crack_area{0};  ///< m2
    Energy energy;
    Vec3 momentum;          ///< kg m/s
    Vec3 angular_momentum;  ///< about the origin, kg m2/s
    std::vector<Support> supports;
    Seconds seconds;
    double steps_per_second{0}, times_real_time{0};
    Memory memory;
    Exchange exchange;
    Forecast forecast;
    std::vector<FrameSeries> frames;
};

/// The text of summary.json: keys in the order above, numbers that are not finite as null, hashes as 16 hex digits.
[[nodiscard]] std::string summary_text(const Summary& summary);

/// Estimated size of that text with `frames` frames, bytes.
[[nodiscard]] std::int64_t summary_bytes(std::int64_t frames);

/// Writes summary.json completely or not at all. Called by the root only, within on_root() of collective_errors.hpp.
/// Throws FileError.
void write_summary(const std::filesystem::path& file, const Summary& summary);

}  // namespace cracksim::io
