#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "partition/communicator.hpp"
#include "support/world.hpp"

namespace cracksim::io {

using test::world;

/// A directory for one test, the same on all ranks, removed with the object. Collective.
class Scratch {
public:
    Scratch() {
        std::string name = (std::filesystem::temp_directory_path() / "cracksim-test-XXXXXX").string();
        if (world().is_root() && mkdtemp(name.data()) == nullptr) {
            name.clear();
        }
        path_ = world().broadcast(name);
    }
    ~Scratch() {
        MPI_Barrier(world().handle());
        if (world().is_root()) {
            std::filesystem::remove_all(path_);
        }
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
    std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream{file};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

inline void touch(const std::filesystem::path& file, const std::string& text = "x") { std::ofstream{file} << text; }

/// True if a file anywhere below the directory has the name of an unfinished file.
inline bool has_unfinished(const std::filesystem::path& directory) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator{directory}) {
        if (entry.path().extension() == ".tmp") {
            return true;
        }
    }
    return false;
}

}  // namespace cracksim::io
