#include "io/summary.hpp"

#include <nlohmann/json.hpp>

#include "core/contracts.hpp"
#include "core/text.hpp"
#include "io/text_file.hpp"

namespace cracksim::io {

namespace {

using Json = nlohmann::ordered_json;

std::string text(Status status) {
    switch (status) {
        case Status::finished: return "finished";
        case Status::stopped: return "stopped";
        case Status::invalid: return "invalid";
    }
    return {};
}

Json json(const Provenance& p) {
    Json libraries = Json::object();
    for (const auto& [name, version] : p.libraries) {
        libraries[name] = version;
    }
    return {{"version", p.version},
            {"git", p.git},
            {"compiler", p.compiler},
            {"flags", p.flags},
            {"build_type", p.build_type},
            {"libraries", libraries},
            {"cpu", p.cpu},
            {"simd_target", p.simd_target},
            {"ranks", p.ranks},
            {"host", p.host},
            {"seed", p.seed},
            {"input_digest", p.input_digest}};
}

Json json(const Summary::Invalid& i) { return {{"step", i.step}, {"mass", i.mass.value()}, {"cause", i.cause}}; }

Json json(const ProblemCounts& c) {
    return {{"entities", c.entities},
            {"masses", c.masses},
            {"interactions", c.interactions},
            {"duplets", c.duplets},
            {"unions", c.unions},
            {"darts", c.darts},
            {"interior_faces", c.interior_faces},
            {"notched_faces", c.notched_faces}};
}

Json json(const Summary::Time& t) {
    return {{"scheme", t.scheme},           {"precision", t.precision}, {"step", t.step}, {"bound", t.bound},
            {"bound_cause", t.bound_cause}, {"steps", t.steps},         {"end", t.end}};
}

Json json(const Summary::Events& e) { return {{"duplets", e.duplets}, {"splits", e.splits}}; }

Json json(const Summary::Fragment& f) { return {{"id", f.id.value()}, {"volume_share", f.volume_share}}; }

Json json(const Summary::Energy& e) {
    return {{"kinetic", e.kinetic},   {"elastic", e.elastic},   {"dissipated", e.dissipated},
            {"external", e.external}, {"residual", e.residual}, {"scale", e.scale}};
}

Json json(Vec3 v) { return {v.x, v.y, v.z}; }

Json json_by_name(const std::vector<Summary::Support>& all) {
    Json result = Json::object();
    for (const Summary::Support& support : all) {
        result[support.name] = {
            {"force", json(support.force)}, {"displacement", json(support.displacement)}, {"work", support.work}};
    }
    return result;
}

Json json(const Summary::Seconds& s) {
    return {{"total", s.total},       {"setup", s.setup},       {"force", s.force},
            {"update", s.update},     {"sense", s.sense},       {"exchange", s.exchange},
            {"topology", s.topology}, {"geometry", s.geometry}, {"output", s.output}};
}

Json json(const Summary::Memory& m) {
    return {{"per_rank_max", m.per_rank_max}, {"per_entity", m.per_entity}, {"map_per_entity", m.map_per_entity}};
}

Json json(const Summary::Exchange& e) {
    return {{"bytes_per_step", e.bytes_per_step}, {"neighbours_max", e.neighbours_max}, {"waiting", e.waiting}};
}

Json json(const Summary::Forecast& f) {
    return {{"memory_intact", f.memory_intact},
            {"memory_broken", f.memory_broken},
            {"exchange_intact", f.exchange_intact},
            {"exchange_broken", f.exchange_broken},
            {"output_intact", f.output_intact},
            {"output_broken", f.output_broken},
            {"output_per_interface", f.output_per_interface}};
}

Json json(const FrameRecord& f) {
    return {{"file", f.file}, {"step", f.step}, {"time", f.time}, {"faces", f.faces}, {"points", f.points}};
}

template <class T>
Json json(const std::vector<T>& items) {
    Json list = Json::array();
    for (const T& item : items) {
        list.push_back(json(item));
    }
    return list;
}

Json json_by_name(const std::vector<FrameSeries>& all) {
    Json result = Json::object();
    for (const FrameSeries& series : all) {
        result[series.name] = json(series.frames);
    }
    return result;
}

void add_results(Json& out, const Summary& s) {
    out["events"] = json(s.events);
    out["event_hash"] = hex(s.event_hash);
    // The state of an invalid run depends on the number of ranks and on the step at which the error was detected.
    out["state_hash"] = s.status == Status::invalid ? Json{} : Json(hex(s.state_hash));
    out["fragments"] = s.fragments;
    out["components"] = s.components;
    out["largest_fragments"] = json(s.largest_fragments);
    out["crack_area"] = s.crack_area;
    out["energy"] = json(s.energy);
    out["momentum"] = json(s.momentum);
    out["angular_momentum"] = json(s.angular_momentum);
    out["supports"] = json_by_name(s.supports);
}

void add_costs(Json& out, const Summary& s) {
    out["seconds"] = json(s.seconds);
    out["steps_per_second"] = s.steps_per_second;
    out["times_real_time"] = s.times_real_time;
    out["memory"] = json(s.memory);
    out["exchange"] = json(s.exchange);
    out["forecast"] = json(s.forecast);
}

}  // namespace

std::string summary_text(const Summary& summary) {
    CRACKSIM_EXPECT(summary.invalid.has_value() == (summary.status == Status::invalid));
    CRACKSIM_EXPECT(summary.error.has_value() == (summary.status == Status::stopped));
    Json out;
    out["status"] = text(summary.status);
    if (summary.invalid) {
        out["invalid"] = json(*summary.invalid);
    }
    if (summary.error) {
        out["error"] = *summary.error;
    }
    out["bitwise"] = summary.bitwise;
    out["provenance"] = json(summary.provenance);
    out["counts"] = json(summary.counts);
    out["time"] = json(summary.time);
    add_results(out, summary);
    add_costs(out, summary);
    out["frames"] = json_by_name(summary.frames);
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::int64_t summary_bytes(std::int64_t frames) {
    constexpr std::int64_t without_frames = 2800;
    constexpr std::int64_t typical_frame = 170;
    return without_frames + frames * typical_frame;
}

void write_summary(const std::filesystem::path& file, const Summary& summary) {
    write_text(file, summary_text(summary));
}

}  // namespace cracksim::io
