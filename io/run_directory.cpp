#include "io/run_directory.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>

#include "core/errors.hpp"
#include "io/collective_errors.hpp"
#include "io/text_file.hpp"

namespace cracksim::io {

namespace {

namespace fs = std::filesystem;

using Problem = std::optional<std::string>;

constexpr std::string_view marker = ".cracksim";
constexpr std::string_view marker_text =
    "This directory was made by cracksim. A new run with the same --out replaces the files that cracksim wrote here.\n";
constexpr std::array<std::string_view, 7> single_files{
    "summary.json", "history.csv",        "events.hdf", "checkpoint.hdf", "checkpoint.previous.hdf",
    "cracksim.log", "input.resolved.yaml"};
constexpr std::string_view unfinished_ending = ".tmp";

std::string_view without_ending(std::string_view name, std::string_view ending) {
    return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : name;
}

bool is_series(std::string_view name) { return std::ranges::find(series_names, name) != series_names.end(); }

Problem problem(const fs::path& path, const std::string& why, const std::string& advice) {
    return "cannot write to " + path.string() + ": " + why + "; " + advice;
}

const std::string other_directory = "name another directory with --out";

bool writable(const fs::path& directory) { return ::access(directory.c_str(), W_OK | X_OK) == 0; }

Problem problem_of_parent(const fs::path& path) {
    const fs::path absolute = fs::absolute(path);
    const fs::path parent = (absolute.has_filename() ? absolute : absolute.parent_path()).parent_path();
    std::error_code error;
    const fs::file_status status = fs::status(parent, error);
    if (status.type() == fs::file_type::not_found) {
        return problem(path, "the directory " + parent.string() + " does not exist",
                       "create it, or " + other_directory);
    }
    if (!fs::is_directory(status)) {
        return problem(path, parent.string() + " is not a directory", other_directory);
    }
    if (!writable(parent)) {
        return problem(path, "nothing can be created in " + parent.string(), other_directory);
    }
    return std::nullopt;
}

Problem problem_of_directory(const fs::path& path) {
    std::error_code error;
    if (!writable(path)) {
        return problem(path, "it is not writable", other_directory);
    }
    const bool empty = fs::is_empty(path, error);
    if (error) {
        return problem(path, error.message(), other_directory);
    }
    if (!empty && !fs::exists(path / marker, error)) {
        return problem(path, "it is not empty and was not made by cracksim", other_directory + ", or empty it");
    }
    for (const std::string_view name : single_files) {
        if (fs::is_directory(path / name, error)) {
            return problem(path, std::string{name} + " in it is a directory", "remove it, or " + other_directory);
        }
    }
    if (fs::exists(path / "frames", error) && !fs::is_directory(path / "frames", error)) {
        return problem(path, "frames in it is not a directory", "remove it, or " + other_directory);
    }
    return std::nullopt;
}

Problem problem_of(const fs::path& path) {
    if (path.empty()) {
        return "the name of the directory to write to is empty; " + other_directory;
    }
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) {
        return fs::is_symlink(fs::symlink_status(path, error))
                   ? problem(path, "it is a link that leads nowhere", other_directory)
                   : problem_of_parent(path);
    }
    if (!fs::status_known(status)) {
        return problem(path, error.message(), other_directory);
    }
    return fs::is_directory(status) ? problem_of_directory(path)
                                    : problem(path, "it is a file, not a directory", other_directory);
}

Problem problem_of_lock(const fs::path& path) {
    return problem(path, "another run is writing to it", "wait for its end, or " + other_directory);
}

void require(const partition::Communicator& comm, const Problem& found_by_root) {
    if (const Problem found = comm.first(found_by_root)) {
        throw InputError{*found};
    }
}

void remove_files(const fs::path& directory, bool (*is_ours)(std::string_view)) {
    std::vector<fs::path> ours;
    for (const auto& entry : fs::directory_iterator{directory}) {
        if (is_ours(entry.path().filename().string()) && (entry.is_symlink() || !entry.is_directory())) {
            ours.push_back(entry.path());
        }
    }
    std::ranges::for_each(ours, [](const fs::path& file) { fs::remove(file); });
}

}  // namespace

bool is_run_file(std::string_view name) {
    const std::string_view finished = without_ending(name, unfinished_ending);
    if (std::ranges::find(single_files, finished) != single_files.end()) {
        return true;
    }
    for (const std::string_view ending : {".xdmf", ".hdf.series"}) {
        if (finished.ends_with(ending) && is_series(without_ending(finished, ending))) {
            return true;
        }
    }
    return false;
}

bool is_frame_file(std::string_view name) {
    const std::string_view finished = without_ending(name, unfinished_ending);
    const std::string_view stem = without_ending(finished, ".hdf");
    const std::size_t dash = stem.rfind('-');
    if (stem.size() == finished.size() || dash == std::string_view::npos || !is_series(stem.substr(0, dash))) {
        return false;
    }
    const std::string_view number = stem.substr(dash + 1);
    return number.size() >= 6 && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
}

void RunDirectory::check(const partition::Communicator& comm) const {
    Problem found;
    if (comm.is_root()) {
        found = problem_of(path_);
        if (!found && !RunLock::take(path_ / marker)) {
            found = problem_of_lock(path_);
        }
    }
    require(comm, found);
}

// The marker is written first: if this run is killed right after, the next run may still use the directory.
RunLock RunDirectory::prepare(const partition::Communicator& comm) const {
    require(comm, comm.is_root() ? problem_of(path_) : std::nullopt);
    std::optional<RunLock> lock;
    Problem refused;
    on_root(comm, [&] {
        std::error_code error;
        fs::create_directory(path_, error);
        if (error) {
            refused = problem(path_, error.message(), other_directory);
            return;
        }
        if (!fs::exists(path_ / marker)) {
            write_text(path_ / marker, marker_text);
        }
        lock = RunLock::take(path_ / marker);
    });
    require(comm, refused);
    require(comm, comm.is_root() && !lock ? problem_of_lock(path_) : std::nullopt);
    on_root(comm, [&] {
        // Old files are removed before any step that may find the disk full: nobody must take them for files of this
        // run.
        remove_files(path_, is_run_file);
        fs::create_directory(path_ / "frames");
        remove_files(path_ / "frames", is_frame_file);
    });
    return lock ? std::move(*lock) : RunLock{};
}

}  // namespace cracksim::io
