#include "io/distributed_mesh.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <variant>

#include "io/collective_errors.hpp"
#include "io/file_error.hpp"

namespace cracksim::io {

namespace {

using geometry::CellField;
using geometry::Mesh;

bool is_integer(const CellField& field) { return std::holds_alternative<std::vector<std::int64_t>>(field.values); }

std::string describe(const Mesh& mesh) {
    std::string text = mesh.kind == geometry::CellKind::point ? "point\n" : "quadrilateral\n";
    for (const CellField& field : mesh.fields) {
        text += (is_integer(field) ? "i " : "d ") + field.name + "\n";
    }
    return text;
}

CellLayout parse(const std::string& description) {
    CellLayout layout;
    std::istringstream lines{description};
    std::string line;
    std::getline(lines, line);
    layout.kind = line == "point" ? geometry::CellKind::point : geometry::CellKind::quadrilateral;
    while (std::getline(lines, line)) {
        layout.fields.push_back({line.substr(2), line.front() == 'i'});
    }
    return layout;
}

bool one_value_a_cell(const Mesh& mesh) {
    return std::ranges::all_of(mesh.fields, [&](const CellField& field) {
        const std::size_t size = std::visit([](const auto& values) { return values.size(); }, field.values);
        return static_cast<std::int64_t>(size) == mesh.cells();
    });
}

template <class T>
CellField gathered_field(const partition::Communicator& comm, const Mesh& mesh, std::size_t place,
                         const std::string& name) {
    std::span<const T> own;
    if (mesh.cells() > 0) {
        own = std::get<std::vector<T>>(mesh.fields[place].values);
    }
    return {name, comm.gather(own)};
}

}  // namespace

CellLayout agreed_layout(const partition::Communicator& comm, const Mesh& mesh) {
    const std::string own = describe(mesh);
    const std::string agreed = comm.first(mesh.cells() > 0 ? std::optional{own} : std::nullopt).value_or("");
    all_or_none(comm, [&] {
        if (mesh.cells() > 0 && (own != agreed || !one_value_a_cell(mesh))) {
            throw FileError{
                "cannot write a frame: the ranks' meshes do not have the same kind of cells and the same fields with "
                "one value a cell",
                false};
        }
    });
    return parse(agreed);
}

CellLayout layout_of(const Mesh& mesh) {
    CellLayout layout{.kind = mesh.kind, .fields = {}};
    for (const CellField& field : mesh.fields) {
        layout.fields.push_back({field.name, is_integer(field)});
    }
    return layout;
}

geometry::Mesh gathered(const partition::Communicator& comm, const Mesh& mesh, const CellLayout& layout) {
    Mesh whole{.kind = layout.kind,
               .points = comm.gather(std::span{mesh.points}),
               .connectivity = comm.gather(std::span{mesh.connectivity}),
               .fields = {}};
    for (std::size_t place = 0; place < layout.fields.size(); ++place) {
        const auto& [name, integer] = layout.fields[place];
        whole.fields.push_back(integer ? gathered_field<std::int64_t>(comm, mesh, place, name)
                                       : gathered_field<double>(comm, mesh, place, name));
    }
    return whole;
}

}  // namespace cracksim::io
