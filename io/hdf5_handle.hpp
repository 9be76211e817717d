#pragma once

#include <hdf5.h>

#include <utility>

namespace cracksim::io::hdf5 {

/// Owns an HDF5 identifier and closes it on destruction.
template <herr_t (*CloseId)(hid_t)>
class Handle {
public:
    Handle() = default;
    explicit Handle(hid_t id) : id_{id} {}
    Handle(Handle&& other) noexcept : id_{other.release()} {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ >= 0) {
            CloseId(id_);
        }
    }

    [[nodiscard]] hid_t get() const { return id_; }
    /// Gives up the identifier without closing it.
    [[nodiscard]] hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }

private:
    hid_t id_{H5I_INVALID_HID};
};

using FileHandle = Handle<H5Fclose>;
using Group = Handle<H5Gclose>;
using Object = Handle<H5Oclose>;
using Dataset = Handle<H5Dclose>;
using Dataspace = Handle<H5Sclose>;
using Datatype = Handle<H5Tclose>;
using Attribute = Handle<H5Aclose>;
using PropertyList = Handle<H5Pclose>;

}  // namespace cracksim::io::hdf5
