#include "io/hdf5_error.hpp"

#include <hdf5.h>

#include <cerrno>
#include <string_view>

namespace cracksim::io::hdf5 {

namespace {

struct Stack {
    std::string innermost;
    bool disk_full{false};
};

herr_t collect(unsigned depth, const H5E_error2_t* error, void* into) {
    auto& stack = *static_cast<Stack*>(into);
    const std::string_view text = error->desc == nullptr ? "" : error->desc;
    if (depth == 0) {
        stack.innermost = text;
    }
    for (const std::string_view sign : {"No space left", "errno = 28", "MPI_ERR_NO_SPACE", "quota"}) {
        stack.disk_full = stack.disk_full || text.find(sign) != std::string_view::npos;
    }
    return 0;
}

}  // namespace

void silence_error_printing() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

FileError last_error(const std::string& operation, const std::filesystem::path& file) {
    Stack stack;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &stack);
    H5Eclear2(H5E_DEFAULT);
    if (stack.disk_full) {
        return file_error(operation, file, ENOSPC);
    }
    return {"cannot " + operation + " " + file.string() + " (HDF5: " + stack.innermost + ")", false};
}

}  // namespace cracksim::io::hdf5
