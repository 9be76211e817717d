#include "io/frame_index.hpp"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "io/text_file.hpp"

namespace cracksim::io {

namespace {

void set(pugi::xml_node node, const char* attribute, const std::string& value) {
    node.append_attribute(attribute).set_value(value.c_str());
}

// `dimensions` must equal the dataset's dimensions one by one, or ParaView aborts.
void add_data(pugi::xml_node parent, const FrameRecord& frame, const std::string& dataset, bool integer,
              const std::string& dimensions) {
    pugi::xml_node item = parent.append_child("DataItem");
    set(item, "Format", "HDF");
    set(item, "NumberType", integer ? "Int" : "Float");
    set(item, "Precision", "8");
    set(item, "Dimensions", dimensions);
    item.text().set((frame.file + ":/VTKHDF/" + dataset).c_str());
}

void add_topology(pugi::xml_node grid, const IndexedFrame& frame) {
    const bool points = frame.cells.kind == geometry::CellKind::point;
    pugi::xml_node topology = grid.append_child("Topology");
    set(topology, "TopologyType", points ? "Polyvertex" : "Quadrilateral");
    set(topology, "NodesPerElement", std::to_string(frame.cells.corners()));
    set(topology, "NumberOfElements", std::to_string(frame.record.faces));
    add_data(topology, frame.record, "Connectivity", true, std::to_string(frame.record.faces * frame.cells.corners()));
}

void add_fields(pugi::xml_node grid, const IndexedFrame& frame) {
    for (const FieldInfo& field : frame.cells.fields) {
        pugi::xml_node attribute = grid.append_child("Attribute");
        set(attribute, "Name", field.name);
        set(attribute, "AttributeType", "Scalar");
        set(attribute, "Center", "Cell");
        add_data(attribute, frame.record, "CellData/" + field.name, field.integer, std::to_string(frame.record.faces));
    }
}

void add_grid(pugi::xml_node collection, const std::string& name, const IndexedFrame& frame) {
    pugi::xml_node grid = collection.append_child("Grid");
    set(grid, "Name", name);
    set(grid, "GridType", "Uniform");
    set(grid.append_child("Time"), "Value", exact(frame.record.time));
    add_topology(grid, frame);
    pugi::xml_node geometry = grid.append_child("Geometry");
    set(geometry, "GeometryType", "XYZ");
    add_data(geometry, frame.record, "Points", false, std::to_string(frame.record.points) + " 3");
    add_fields(grid, frame);
}

}  // namespace

std::string xdmf_text(const std::string& name, std::span<const IndexedFrame> frames) {
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("Xdmf");
    set(root, "Version", "3.0");
    pugi::xml_node collection = root.append_child("Domain").append_child("Grid");
    set(collection, "Name", name);
    set(collection, "GridType", "Collection");
    set(collection, "CollectionType", "Temporal");
    for (const IndexedFrame& frame : frames) {
        add_grid(collection, name, frame);
    }
    std::ostringstream text;
    document.save(text, "  ");
    return text.str();
}

std::string series_text(std::span<const IndexedFrame> frames) {
    nlohmann::ordered_json series{{"file-series-version", "1.0"}, {"files", nlohmann::ordered_json::array()}};
    for (const IndexedFrame& frame : frames) {
        series["files"].push_back({{"name", frame.record.file}, {"time", frame.record.time}});
    }
    return series.dump(1) + "\n";
}

std::int64_t index_bytes(const std::string& name, const IndexedFrame& like, std::int64_t frames) {
    if (frames == 0) {
        return 0;
    }
    const auto bytes = [&](std::size_t count) {
        const std::vector<IndexedFrame> some(count, like);
        return static_cast<std::int64_t>(xdmf_text(name, some).size() + series_text(some).size());
    };
    return bytes(1) + (frames - 1) * (bytes(2) - bytes(1));
}

}  // namespace cracksim::io
