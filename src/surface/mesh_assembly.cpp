#include "surface/mesh_assembly.hpp"

#include <algorithm>
#include <iterator>

#include "core/contracts.hpp"

namespace cracksim::surface {

namespace {

using Keys = std::vector<std::int64_t>;

/// The filing rank of an entity, which sorts the entity's records: each rank files an equal range of entity ids,
/// independent of their owners.
std::size_t filing_rank(std::int64_t entity, std::int64_t entities, int ranks) {
    return static_cast<std::size_t>(entity * ranks / entities);
}

/// Sends each record to its filing rank. Returns the records that this rank files, sorted by key, each key once.
template <class Record>
std::vector<Record> filed(const partition::Communicator& comm, const std::vector<Record>& records,
                          std::int64_t entities, std::int64_t keys_per_entity) {
    std::vector<std::vector<Record>> outgoing(static_cast<std::size_t>(comm.size()));
    for (const Record& record : records) {
        outgoing[filing_rank(record.key / keys_per_entity, entities, comm.size())].push_back(record);
    }
    std::vector<Record> all;
    for (auto& part : comm.exchange(outgoing)) {
        std::ranges::move(part, std::back_inserter(all));
    }
    std::ranges::sort(all, {}, &Record::key);
    const auto same = [](const Record& a, const Record& b) { return a.key == b.key; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

std::int64_t place_of(const std::vector<PointRecord>& points, std::int64_t key) {
    const auto found = std::ranges::lower_bound(points, key, {}, &PointRecord::key);
    CRACKSIM_ASSERT(found != points.end() && found->key == key);
    return found - points.begin();
}

/// The global numbers of the wanted points (ascending keys), requested from their filing ranks.
Keys numbers_of(const partition::Communicator& comm, const MeshLayout& layout, const std::vector<PointRecord>& points,
                const Keys& wanted) {
    const std::int64_t first = comm.sum_below(static_cast<std::int64_t>(points.size()));
    std::vector<Keys> asked(static_cast<std::size_t>(comm.size()));
    for (const std::int64_t key : wanted) {
        asked[filing_rank(key / layout.point_keys_per_entity, layout.entities, comm.size())].push_back(key);
    }
    std::vector<Keys> answers = comm.exchange(asked);
    for (Keys& keys : answers) {
        std::ranges::transform(keys, keys.begin(), [&](std::int64_t key) { return first + place_of(points, key); });
    }
    Keys numbers;
    // Filing ranks ascend with the keys, so the concatenated answers are in the order of `wanted`.
    for (const Keys& part : comm.exchange(answers)) {
        numbers.insert(numbers.end(), part.begin(), part.end());
    }
    return numbers;
}

Keys connectivity(const partition::Communicator& comm, const MeshLayout& layout, const std::vector<PointRecord>& points,
                  const std::vector<CellRecord>& cells, std::size_t corners) {
    Keys wanted;
    for (const CellRecord& cell : cells) {
        wanted.insert(wanted.end(), cell.points.begin(), cell.points.begin() + static_cast<std::ptrdiff_t>(corners));
    }
    Keys keys = wanted;
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    const Keys numbers = numbers_of(comm, layout, points, keys);
    std::ranges::transform(wanted, wanted.begin(), [&](std::int64_t key) {
        return numbers[static_cast<std::size_t>(std::ranges::lower_bound(keys, key) - keys.begin())];
    });
    return wanted;
}

template <class T, std::size_t N>
std::vector<T> column(const std::vector<CellRecord>& cells, std::array<T, N> CellRecord::*values, std::size_t i) {
    std::vector<T> all;
    all.reserve(cells.size());
    for (const CellRecord& cell : cells) {
        all.push_back((cell.*values)[i]);
    }
    return all;
}

}  // namespace

geometry::Mesh assemble(const partition::Communicator& comm, const MeshLayout& layout,
                        const std::vector<PointRecord>& points, const std::vector<CellRecord>& cells) {
    const auto filed_points = filed(comm, points, layout.entities, layout.point_keys_per_entity);
    const auto filed_cells = filed(comm, cells, layout.entities, layout.cell_keys_per_entity);
    geometry::Mesh mesh;
    mesh.kind = layout.kind;
    for (const PointRecord& point : filed_points) {
        mesh.points.push_back(point.position);
    }
    mesh.connectivity = connectivity(comm, layout, filed_points, filed_cells, static_cast<std::size_t>(mesh.corners()));
    for (std::size_t i = 0; i < layout.integer_names.size(); ++i) {
        mesh.fields.push_back({layout.integer_names[i], column(filed_cells, &CellRecord::integers, i)});
    }
    for (std::size_t i = 0; i < layout.real_names.size(); ++i) {
        mesh.fields.push_back({layout.real_names[i], column(filed_cells, &CellRecord::reals, i)});
    }
    return mesh;
}

}  // namespace cracksim::surface
