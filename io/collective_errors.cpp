#include "io/collective_errors.hpp"

#include <exception>
#include <optional>
#include <string>

#include "io/file_error.hpp"

namespace cracksim::io {

void all_or_none(const partition::Communicator& comm, const std::function<void()>& action) {
    std::optional<std::string> failure;
    bool disk_full = false;
    try {
        action();
    } catch (const FileError& error) {
        failure = error.what();
        disk_full = error.disk_full();
    } catch (const std::exception& error) {
        failure = error.what();
    }
    if (comm.any(failure.has_value())) {
        const std::string text = comm.first(failure).value_or("");
        throw FileError{text, comm.any(disk_full)};
    }
}

void on_root(const partition::Communicator& comm, const std::function<void()>& action) {
    all_or_none(comm, [&] {
        if (comm.is_root()) {
            action();
        }
    });
}

}  // namespace cracksim::io
