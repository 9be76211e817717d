#pragma once

#include <mpi.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "core/vec3.hpp"
#include "io/hdf5_handle.hpp"

namespace cracksim::io::hdf5 {

/// Starts the HDF5 library if it has not started yet. The start calls MPI, so a thread that may use MPI must call this
/// before a thread that may not use MPI uses HDF5.
void start();

/// Element type and number of columns of a dataset's rows, in memory and in the file.
struct RowType {
    hid_t element;
    hsize_t columns;  ///< 1: a one-dimensional dataset (rows); else a two-dimensional one (rows x columns)
};

template <class T>
[[nodiscard]] RowType row_type();
template <>
[[nodiscard]] inline RowType row_type<double>() {
    return {H5T_NATIVE_DOUBLE, 1};
}
template <>
[[nodiscard]] inline RowType row_type<std::int64_t>() {
    return {H5T_NATIVE_INT64, 1};
}
template <>
[[nodiscard]] inline RowType row_type<std::uint8_t>() {
    return {H5T_NATIVE_UINT8, 1};
}
template <>
[[nodiscard]] inline RowType row_type<MassId>() {
    return {H5T_NATIVE_INT64, 1};
}
template <>
[[nodiscard]] inline RowType row_type<Vec3>() {
    return {H5T_NATIVE_DOUBLE, 3};
}
static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(MassId) == sizeof(std::int64_t));

/// An extendible dataset grows by chunks of this many rows.
constexpr std::int64_t chunk_rows = 4096;

enum class Access { create, modify, read };

/// An open HDF5 file; groups and datasets are named by their full path. Every failure is a FileError that names the
/// file and the operation. If the file was opened with a communicator, every member is collective.
/// A file that was opened for writing must be closed by close(). A file that is destroyed without close() counts as
/// failed and is not closed: HDF5 1.10 ends with a segmentation fault if it failed to close a file.
class File {
public:
    File(std::filesystem::path path, Access access);
    /// Collective.
    File(std::filesystem::path path, Access access, MPI_Comm comm);
    File(File&&) = default;
    File& operator=(File&&) = delete;
    ~File();

    void close();

    void create_group(const std::string& name);
    void set_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
    void set_attribute(const std::string& object, const std::string& name, const std::string& text);

    /// Creates a dataset with a fixed number of rows, all of which must be written.
    template <class T>
    void create(const std::string& name, std::int64_t rows) {
        create_dataset(name, row_type<T>(), rows);
    }
    /// Creates an empty dataset that append() extends.
    template <class T>
    void create_extendible(const std::string& name) {
        create_extendible_dataset(name, row_type<T>());
    }

    /// Writes this rank's rows from row `first` on; a rank may have no rows. Does nothing if the dataset has no rows,
    /// because a collective write to such a dataset fails.
    template <class T>
    void write(const std::string& name, std::int64_t first, std::span<const T> rows) {
        write_rows(name, row_type<T>(), first, static_cast<std::int64_t>(rows.size()), rows.data());
    }
    /// Adds rows at the end of an extendible dataset. Serial files only.
    template <class T>
    void append(const std::string& name, std::span<const T> rows) {
        append_rows(name, row_type<T>(), static_cast<std::int64_t>(rows.size()), rows.data());
    }

    [[nodiscard]] std::int64_t rows(const std::string& name) const;
    /// Reads the whole dataset. Serial files only.
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& name) const {
        std::vector<T> values(static_cast<std::size_t>(rows(name)));
        read_rows(name, row_type<T>(), values.data());
        return values;
    }
    [[nodiscard]] std::vector<std::int64_t> integer_attribute(const std::string& object, const std::string& name) const;
    [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name) const;

private:
    void open(const PropertyList& file_access);
    void create_dataset(const std::string& name, RowType type, std::int64_t rows);
    void create_extendible_dataset(const std::string& name, RowType type);
    void write_rows(const std::string& name, RowType type, std::int64_t first, std::int64_t count, const void* data);
    void append_rows(const std::string& name, RowType type, std::int64_t count, const void* data);
    void read_rows(const std::string& name, RowType type, void* data) const;
    [[nodiscard]] Dataset open_dataset(const std::string& name) const;
    [[nodiscard]] Attribute create_attribute(const std::string& object, const std::string& name, hid_t type,
                                             const Dataspace& space);
    [[nodiscard]] Attribute open_attribute(const std::string& object, const std::string& name) const;

    /// Returns a result of HDF5, or throws FileError if it reports a failure.
    template <class Result>
    Result checked(Result result, const std::string& operation) const;

    std::filesystem::path path_;
    Access access_;
    FileHandle file_;
    PropertyList transfer_;
};

}  // namespace cracksim::io::hdf5
