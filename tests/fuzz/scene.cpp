#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "fuzz/finding.hpp"
#include "scene/resolved.hpp"
#include "scene/scene_reader.hpp"

namespace {

using namespace cracksim;

struct Input {
    std::string scene;
    std::vector<std::string> settings;  ///< values of --set
};

/// Splits the bytes at NUL bytes into a scene and its settings; no argument of a command can hold a NUL byte.
Input split(std::string_view bytes) {
    Input input{std::string{bytes.substr(0, bytes.find('\0'))}, {}};
    for (std::size_t nul = bytes.find('\0'); nul != std::string_view::npos;) {
        const std::size_t next = bytes.find('\0', nul + 1);
        input.settings.emplace_back(bytes.substr(nul + 1, next == std::string_view::npos ? next : next - nul - 1));
        nul = next;
    }
    return input;
}

std::optional<scene::Scene> accepted(const Input& input) {
    try {
        return scene::read_scene(input.scene, "scene.yaml", input.settings);
    } catch (const InputError& error) {
        const std::string_view message = error.what();
        fuzz::require_good_message(message);
        fuzz::require(message.starts_with("scene.yaml:") || message.starts_with("--set"),
                      "a message does not begin with its place");
        return std::nullopt;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto scene = accepted(split({reinterpret_cast<const char*>(data), size}));
    if (scene) {
        const std::string text = scene::resolved(*scene);
        fuzz::require(scene::resolved(scene::read_scene(text, "resolved.yaml", {})) == text,
                      "a resolved scene does not read back as itself");
    }
    return 0;
}
