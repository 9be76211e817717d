#include "io/vtkhdf.hpp"

#include <array>
#include <optional>
#include <variant>

#include "io/collective_errors.hpp"
#include "io/file_error.hpp"
#include "io/hdf5.hpp"

namespace cracksim::io {

namespace {

using geometry::Mesh;

const std::string root = "/VTKHDF";
const std::string cell_data = root + "/CellData/";
const std::string field_data = root + "/FieldData/";

/// Global numbers of this rank's first point and first cell.
struct Begin {
    std::int64_t point;
    std::int64_t cell;
};

void create_datasets(hdf5::File& file, const IndexedFrame& frame) {
    const FrameRecord& record = frame.record;
    const std::int64_t corners = frame.cells.corners();
    for (const auto* group : {&root, &cell_data, &field_data}) {
        file.create_group(*group);
    }
    file.set_attribute(root, "Version", std::array<std::int64_t, 2>{1, 0});
    file.set_attribute(root, "Type", "UnstructuredGrid");
    for (const char* name : {"/NumberOfPoints", "/NumberOfCells", "/NumberOfConnectivityIds"}) {
        file.create<std::int64_t>(root + name, 1);
    }
    file.create<Vec3>(root + "/Points", record.points);
    file.create<std::int64_t>(root + "/Connectivity", record.faces * corners);
    file.create<std::int64_t>(root + "/Offsets", record.faces + 1);
    file.create<std::uint8_t>(root + "/Types", record.faces);
    for (const FieldInfo& field : frame.cells.fields) {
        field.integer ? file.create<std::int64_t>(cell_data + field.name, record.faces)
                      : file.create<double>(cell_data + field.name, record.faces);
    }
    file.create<std::int64_t>(field_data + "Step", 1);
    file.create<double>(field_data + "TimeValue", 1);
}

/// Writes datasets one after the other. A rank that fails still takes part in all collective writes that follow, or the
/// other ranks would wait for it forever; the first failure is thrown at the end.
class Datasets {
public:
    explicit Datasets(hdf5::File& file, bool is_root) : file_{file}, is_root_{is_root} {}

    template <class T>
    void write(const std::string& name, std::int64_t first, std::span<const T> rows) {
        try {
            file_.write(name, first, rows);
        } catch (const FileError& error) {
            failure_ = failure_ ? failure_ : error;
        }
    }
    /// Writes a dataset of one row; only the root writes.
    template <class T>
    void write_one(const std::string& name, const T& value) {
        write(name, 0, std::span{&value, is_root_ ? std::size_t{1} : std::size_t{0}});
    }
    void throw_first_failure() const {
        if (failure_) {
            throw FileError{*failure_};
        }
    }

private:
    hdf5::File& file_;
    bool is_root_;
    std::optional<FileError> failure_;
};

void write_sizes(Datasets& datasets, const FrameRecord& record, std::int64_t corners) {
    datasets.write_one(root + "/NumberOfPoints", record.points);
    datasets.write_one(root + "/NumberOfCells", record.faces);
    datasets.write_one(root + "/NumberOfConnectivityIds", record.faces * corners);
    datasets.write_one(field_data + "Step", record.step);
    datasets.write_one(field_data + "TimeValue", record.time);
}

/// Offsets of this rank's cells; the offsets of the root begin with the leading 0.
std::vector<std::int64_t> cell_ends(const Mesh& mesh, std::int64_t first_cell, bool leading_zero) {
    std::vector<std::int64_t> ends;
    for (std::int64_t cell = leading_zero ? 0 : 1; cell <= mesh.cells(); ++cell) {
        ends.push_back((first_cell + cell) * mesh.corners());
    }
    return ends;
}

void write_cells(Datasets& datasets, const Mesh& mesh, std::int64_t first_cell, bool is_root) {
    using Integers = std::span<const std::int64_t>;
    datasets.write(root + "/Connectivity", first_cell * mesh.corners(), Integers{mesh.connectivity});
    const std::vector<std::int64_t> ends = cell_ends(mesh, first_cell, is_root);
    datasets.write(root + "/Offsets", is_root ? 0 : first_cell + 1, Integers{ends});
    const std::vector<std::uint8_t> types(static_cast<std::size_t>(mesh.cells()), static_cast<std::uint8_t>(mesh.kind));
    datasets.write(root + "/Types", first_cell, std::span<const std::uint8_t>{types});
}

template <class T>
void write_field(Datasets& datasets, const Mesh& mesh, std::size_t place, const std::string& name,
                 std::int64_t first_cell) {
    std::span<const T> values;
    if (mesh.cells() > 0) {
        values = std::get<std::vector<T>>(mesh.fields[place].values);
    }
    datasets.write(cell_data + name, first_cell, values);
}

void write_fields(Datasets& datasets, const Mesh& mesh, const std::vector<FieldInfo>& fields, std::int64_t first_cell) {
    for (std::size_t place = 0; place < fields.size(); ++place) {
        fields[place].integer ? write_field<std::int64_t>(datasets, mesh, place, fields[place].name, first_cell)
                              : write_field<double>(datasets, mesh, place, fields[place].name, first_cell);
    }
}

Datasets write_datasets(hdf5::File& file, const Mesh& mesh, const IndexedFrame& frame, Begin begin, bool is_root) {
    Datasets datasets{file, is_root};
    write_sizes(datasets, frame.record, frame.cells.corners());
    datasets.write(root + "/Points", begin.point, std::span{mesh.points});
    write_cells(datasets, mesh, begin.cell, is_root);
    write_fields(datasets, mesh, frame.cells.fields, begin.cell);
    return datasets;
}

}  // namespace

std::int64_t vtkhdf_bytes(const IndexedFrame& frame) {
    constexpr std::int64_t headers = 65536;
    const auto values_a_cell = frame.cells.corners() + 1 + static_cast<std::int64_t>(frame.cells.fields.size());
    return headers + 24 * frame.record.points + frame.record.faces * (8 * values_a_cell + 1);
}

void write_vtkhdf(const std::filesystem::path& file, const Mesh& mesh, const IndexedFrame& frame) {
    hdf5::File open{file, hdf5::Access::create};
    create_datasets(open, frame);
    reserve_space(file, vtkhdf_bytes(frame));
    write_datasets(open, mesh, frame, {0, 0}, true).throw_first_failure();
    open.close();
}

void write_vtkhdf(const partition::Communicator& comm, const std::filesystem::path& file, const Mesh& mesh,
                  const IndexedFrame& frame) {
    if (comm.size() == 1) {
        write_vtkhdf(file, mesh, frame);
        return;
    }
    const Begin begin{comm.sum_below(static_cast<std::int64_t>(mesh.points.size())), comm.sum_below(mesh.cells())};
    std::optional<hdf5::File> open;
    all_or_none(comm, [&] {
        open.emplace(file, hdf5::Access::create, comm.handle());
        create_datasets(*open, frame);
    });
    on_root(comm, [&] { reserve_space(file, vtkhdf_bytes(frame)); });
    const Datasets datasets = write_datasets(*open, mesh, frame, begin, comm.is_root());
    all_or_none(comm, [&] { datasets.throw_first_failure(); });
    all_or_none(comm, [&] { open->close(); });
}

}  // namespace cracksim::io
