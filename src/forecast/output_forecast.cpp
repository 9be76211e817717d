#include "forecast/output_forecast.hpp"

#include <algorithm>

#include "core/hexahedron.hpp"
#include "io/event_writer.hpp"
#include "io/history_writer.hpp"
#include "io/summary.hpp"
#include "io/vtkhdf.hpp"
#include "scene/resolved.hpp"
#include "scene/schedule.hpp"
#include "surface/frame_meshes.hpp"

namespace cracksim::forecast {

namespace {

/// cracksim.log and the marker file of the directory: a few lines for any scene.
constexpr std::int64_t small_files = 1500;

io::CellLayout cells_of(const surface::MeshLayout& layout) {
    io::CellLayout cells{.kind = layout.kind, .fields = {}};
    for (const std::string& name : layout.integer_names) {
        cells.fields.push_back({name, true});
    }
    for (const std::string& name : layout.real_names) {
        cells.fields.push_back({name, false});
    }
    return cells;
}

std::int64_t frame_bytes(const io::CellLayout& cells, std::int64_t faces, std::int64_t points) {
    return faces == 0 ? 0 : io::vtkhdf_bytes({{.file = {}, .faces = faces, .points = points}, cells});
}

/// When a crack grows by one interior face, each later frame has two more faces and two more points.
SeriesForecast series(std::string name, const surface::MeshLayout& layout, Range faces, Range points) {
    const io::CellLayout cells = cells_of(layout);
    const Range bytes{frame_bytes(cells, faces.intact, points.intact), frame_bytes(cells, faces.broken, points.broken)};
    const bool grows = faces.intact != faces.broken;
    const std::int64_t added = grows ? frame_bytes(cells, 3, 3) - frame_bytes(cells, 1, 1) : 0;
    return {std::move(name), cells, faces, points, bytes, added};
}

/// Vertices on the block's boundary.
std::int64_t boundary_vertices(const Block& block) {
    const auto [nx, ny, nz] = block.cells();
    return block.vertex_count() - (nx - 1) * (ny - 1) * (nz - 1);
}

/// Number of steps from 0 to `last` at which output is written: the due steps, the first and the last.
std::int64_t times(const scene::Schedule& schedule, std::int64_t last) {
    return schedule.due_until(last) + (schedule.is_due(0) ? 0 : 1) + (schedule.is_due(last) || last == 0 ? 0 : 1);
}

/// Number of coats: a coat is updated at its own rate and for each frame. Above a million coats, their common steps are
/// not counted: the result assumes that the rarer of the two is never due alone.
std::int64_t coats(const scene::Schedule& coat, double coat_rate, const scene::Schedule& frame, std::int64_t last) {
    std::int64_t count = times(frame, last);
    if (!(coat_rate > 0)) {
        return count;
    }
    constexpr std::int64_t most_counted = 1'000'000;
    if (const std::int64_t due = times(coat, last); due > most_counted) {
        return std::max(count, due);
    }
    for (std::int64_t step = coat.next_due(0); step < last; step = coat.next_due(step)) {
        count += frame.is_due(step) ? 0 : 1;
    }
    return count;
}

/// times * bytes, limited so that a sum of a few products does not overflow.
std::int64_t capped_product(std::int64_t times, std::int64_t bytes) {
    constexpr std::int64_t most = std::int64_t{1} << 60;
    return static_cast<double>(times) * static_cast<double>(bytes) < static_cast<double>(most) ? times * bytes : most;
}

/// One end of a range.
using End = std::int64_t Range::*;

/// The first frame is intact at both ends of the range: faces that open in the first step open after it.
std::int64_t frames_written(const SeriesForecast& series, std::int64_t later, End end) {
    return (series.frame_bytes.intact > 0 ? 1 : 0) + (series.frame_bytes.*end > 0 ? later : 0);
}

/// Bytes of all frames of a series and of their index, which has times of typical length.
std::int64_t series_bytes(const SeriesForecast& series, std::int64_t later, End end) {
    io::IndexedFrame typical;
    typical.cells = series.cells;
    typical.record.file = "frames/" + series.name + "-000000.hdf";
    typical.record.time = 1.0 / 3.0;
    typical.record.faces = series.faces.*end;
    typical.record.points = series.points.*end;
    return series.frame_bytes.intact + capped_product(later, series.frame_bytes.*end) +
           io::index_bytes(series.name, typical, frames_written(series, later, end));
}

std::int64_t all_bytes(const scene::Scene& scene, const OutputForecast& forecast, End end) {
    const std::int64_t later = forecast.frames - 1;
    std::int64_t bytes = small_files + static_cast<std::int64_t>(scene::resolved(scene).size()) +
                         io::history_bytes(forecast.history_rows, scene::support_names(scene));
    std::int64_t frames = 0;
    for (const SeriesForecast& one : forecast.series) {
        bytes += series_bytes(one, later, end);
        frames += frames_written(one, later, end);
    }
    return bytes + io::summary_bytes(frames);
}

}  // namespace

std::vector<SeriesForecast> forecast_series(const scene::Scene& scene, const ProblemCounts& counts) {
    const Block& block = scene.block;
    const std::int64_t all_faces = block.entity_count() * Hexahedron::faces;
    const std::int64_t boundary = all_faces - 2 * block.interior_face_count();
    const std::int64_t masses = block.mass_count();
    // Both sides of a notch are free faces. Most of their vertices lie inside the notch: about one a face on either
    // side.
    const std::int64_t notched = 2 * counts.notched_faces;
    std::vector<SeriesForecast> all;
    if (scene.output.surface) {
        all.push_back(series("surface", surface::surface_layout(block), {boundary + notched, all_faces},
                             {boundary_vertices(block) + notched, masses}));
    }
    if (scene.output.crack) {
        all.push_back(series("crack", surface::surface_layout(block), {notched, all_faces - boundary},
                             {notched, boundary == all_faces ? 0 : masses}));
    }
    if (scene.output.masses) {
        all.push_back(series("masses", surface::mass_layout(block), {masses, masses}, {masses, masses}));
    }
    if (scene.output.topology) {
        const std::int64_t corners = all_faces * Hexahedron::face_corners;
        all.push_back(series("topology", surface::topology_layout(block), {all_faces, all_faces}, {corners, corners}));
    }
    return all;
}

OutputForecast forecast_output(const scene::Scene& scene, const scene::CertifiedStep& certified,
                               const ProblemCounts& counts) {
    const scene::Schedule frame{scene.output.rate, certified.step};
    OutputForecast forecast;
    forecast.frames = times(frame, certified.steps);
    forecast.coats = coats(scene::Schedule{scene.coat_rate, certified.step}, scene.coat_rate, frame, certified.steps);
    forecast.history_rows = times(scene::Schedule{scene.history_rate, certified.step}, certified.steps);
    forecast.series = forecast_series(scene, counts);

    for (const SeriesForecast& one : forecast.series) {
        forecast.per_face += one.per_face;
    }
    const std::int64_t masses = scene.block.mass_count();
    forecast.bytes = {
        all_bytes(scene, forecast, &Range::intact) + io::event_file_bytes(0, 0, 0),
        all_bytes(scene, forecast, &Range::broken) + io::event_file_bytes(counts.duplets, masses, masses)};
    return forecast;
}

}  // namespace cracksim::forecast
