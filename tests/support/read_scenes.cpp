#include <cstdio>
#include <iostream>
#include <string>

#include "core/errors.hpp"
#include "scene/scene_reader.hpp"

/// Reads scenes from standard input, each ended by a NUL byte. Prints a line for each scene: the reader's error
/// message, or nothing if the scene is valid.
int main() {
    using namespace cracksim;
    for (std::string scene; std::getline(std::cin, scene, '\0');) {
        try {
            static_cast<void>(scene::read_scene(scene, "scene.yaml", {}));
            std::puts("");
        } catch (const InputError& error) {
            std::puts(error.what());
        }
    }
    return 0;
}
