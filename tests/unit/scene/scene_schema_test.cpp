#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "scene/scene_reader.hpp"

namespace cracksim::scene {
namespace {

using Json = nlohmann::json;

/// Adds the path of every property below a map of the schema; * stands for any item of a list.
void add_keys(const Json& map, const std::string& parent, std::set<std::string>& keys) {
    const Json properties = map.value("properties", Json::object());
    for (const auto& [name, property] : properties.items()) {
        keys.insert(parent + name);
        add_keys(property, parent + name + ".", keys);
        add_keys(property.value("items", Json::object()), parent + name + ".*.", keys);
    }
}

TEST(SceneSchema, NamesTheKeysThatTheReaderKnows) {
    std::ifstream file{std::string{CRACKSIM_SOURCE_DIR} + "/inputs/scene.schema.json"};
    std::set<std::string> named;
    add_keys(Json::parse(file), "", named);
    const std::vector<std::string> known = known_keys();
    EXPECT_EQ(named, (std::set<std::string>{known.begin(), known.end()}));
}

}  // namespace
}  // namespace cracksim::scene
