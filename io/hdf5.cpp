#include "io/hdf5.hpp"

#include <array>

#include "core/contracts.hpp"
#include "io/hdf5_error.hpp"

namespace cracksim::io::hdf5 {

namespace {

using Sizes = std::array<hsize_t, 2>;

int dimensions(RowType type) { return type.columns == 1 ? 1 : 2; }

hsize_t size_of(std::int64_t rows) { return static_cast<hsize_t>(rows); }

}  // namespace

template <class Result>
Result File::checked(Result result, const std::string& operation) const {
    if (result < 0) {
        throw last_error(operation, path_);
    }
    return result;
}

void start() { H5open(); }

// File locks are off, so that a program that reads the file during a run does not make the run fail.
File::File(std::filesystem::path path, Access access) : path_{std::move(path)}, access_{access} {
    silence_error_printing();
    transfer_ = PropertyList{checked(H5Pcreate(H5P_DATASET_XFER), "set up the writing of")};
    const PropertyList file_access{checked(H5Pcreate(H5P_FILE_ACCESS), "set up the opening of")};
    checked(H5Pset_file_locking(file_access.get(), false, true), "switch off locks for");
    open(file_access);
}

File::File(std::filesystem::path path, Access access, MPI_Comm comm) : path_{std::move(path)}, access_{access} {
    silence_error_printing();
    transfer_ = PropertyList{checked(H5Pcreate(H5P_DATASET_XFER), "set up the writing of")};
    checked(H5Pset_dxpl_mpio(transfer_.get(), H5FD_MPIO_COLLECTIVE), "set up the writing of");
    const PropertyList file_access{checked(H5Pcreate(H5P_FILE_ACCESS), "set up the opening of")};
    checked(H5Pset_fapl_mpio(file_access.get(), comm, MPI_INFO_NULL), "set up parallel access to");
    checked(H5Pset_all_coll_metadata_ops(file_access.get(), true), "set up parallel access to");
    checked(H5Pset_coll_metadata_write(file_access.get(), true), "set up parallel access to");
    open(file_access);
}

void File::open(const PropertyList& file_access) {
    const char* name = path_.c_str();
    if (access_ == Access::create) {
        file_ = FileHandle{checked(H5Fcreate(name, H5F_ACC_TRUNC, H5P_DEFAULT, file_access.get()), "create")};
    } else {
        const unsigned mode = access_ == Access::modify ? H5F_ACC_RDWR : H5F_ACC_RDONLY;
        file_ = FileHandle{checked(H5Fopen(name, mode, file_access.get()), "open")};
    }
}

File::~File() {
    if (access_ != Access::read) {
        (void)file_.release();
    }
}

void File::close() { checked(H5Fclose(file_.release()), "write the end of"); }

void File::create_group(const std::string& name) {
    const Group group{checked(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                              "make the group " + name + " in")};
}

// Fill values are off: every row is written, and filling would write it twice. Time stamps are off: equal runs give
// equal files.
void File::create_dataset(const std::string& name, RowType type, std::int64_t rows) {
    const std::string operation = "make the dataset " + name + " in";
    const Sizes sizes{size_of(rows), type.columns};
    const Dataspace space{checked(H5Screate_simple(dimensions(type), sizes.data(), nullptr), operation)};
    const PropertyList creation{checked(H5Pcreate(H5P_DATASET_CREATE), operation)};
    checked(H5Pset_fill_time(creation.get(), H5D_FILL_TIME_NEVER), operation);
    checked(H5Pset_obj_track_times(creation.get(), false), operation);
    const Dataset dataset{checked(
        H5Dcreate2(file_.get(), name.c_str(), type.element, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        operation)};
}

void File::create_extendible_dataset(const std::string& name, RowType type) {
    const std::string operation = "make the dataset " + name + " in";
    const Sizes sizes{0, type.columns};
    const Sizes limits{H5S_UNLIMITED, type.columns};
    const Sizes chunk{size_of(chunk_rows), type.columns};
    const Dataspace space{checked(H5Screate_simple(dimensions(type), sizes.data(), limits.data()), operation)};
    const PropertyList creation{checked(H5Pcreate(H5P_DATASET_CREATE), operation)};
    checked(H5Pset_chunk(creation.get(), dimensions(type), chunk.data()), operation);
    checked(H5Pset_obj_track_times(creation.get(), false), operation);
    const Dataset dataset{checked(
        H5Dcreate2(file_.get(), name.c_str(), type.element, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
        operation)};
}

Dataset File::open_dataset(const std::string& name) const {
    return Dataset{checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), "find the dataset " + name + " in")};
}

std::int64_t File::rows(const std::string& name) const {
    const std::string operation = "read the size of " + name + " in";
    const Dataset dataset = open_dataset(name);
    const Dataspace space{checked(H5Dget_space(dataset.get()), operation)};
    Sizes sizes{};
    [[maybe_unused]] const int dimensions = checked(H5Sget_simple_extent_ndims(space.get()), operation);
    CRACKSIM_ASSERT(dimensions == 1 || dimensions == 2);
    checked(H5Sget_simple_extent_dims(space.get(), sizes.data(), nullptr), operation);
    return static_cast<std::int64_t>(sizes[0]);
}

void File::write_rows(const std::string& name, RowType type, std::int64_t first, std::int64_t count, const void* data) {
    if (rows(name) == 0) {
        return;
    }
    const std::string operation = "write the dataset " + name + " of";
    const Dataset dataset = open_dataset(name);
    const Dataspace target{checked(H5Dget_space(dataset.get()), operation)};
    const Sizes start{size_of(first), 0};
    const Sizes sizes{size_of(count), type.columns};
    const Dataspace source{checked(H5Screate_simple(dimensions(type), sizes.data(), nullptr), operation)};
    if (count == 0) {
        checked(H5Sselect_none(target.get()), operation);
        checked(H5Sselect_none(source.get()), operation);
    } else {
        checked(H5Sselect_hyperslab(target.get(), H5S_SELECT_SET, start.data(), nullptr, sizes.data(), nullptr),
                operation);
    }
    checked(H5Dwrite(dataset.get(), type.element, source.get(), target.get(), transfer_.get(), data), operation);
}

void File::append_rows(const std::string& name, RowType type, std::int64_t count, const void* data) {
    const std::int64_t before = rows(name);
    const Sizes sizes{size_of(before + count), type.columns};
    checked(H5Dset_extent(open_dataset(name).get(), sizes.data()), "extend the dataset " + name + " of");
    write_rows(name, type, before, count, data);
}

void File::read_rows(const std::string& name, RowType type, void* data) const {
    if (rows(name) == 0) {
        return;
    }
    checked(H5Dread(open_dataset(name).get(), type.element, H5S_ALL, H5S_ALL, H5P_DEFAULT, data),
            "read the dataset " + name + " of");
}

Attribute File::create_attribute(const std::string& object, const std::string& name, hid_t type,
                                 const Dataspace& space) {
    return Attribute{checked(H5Acreate_by_name(file_.get(), object.c_str(), name.c_str(), type, space.get(),
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             "make the attribute " + name + " in")};
}

Attribute File::open_attribute(const std::string& object, const std::string& name) const {
    return Attribute{checked(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                             "find the attribute " + name + " in")};
}

void File::set_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values) {
    const hsize_t size = values.size();
    const Dataspace space{checked(H5Screate_simple(1, &size, nullptr), "make the attribute " + name + " in")};
    const Attribute attribute = create_attribute(object, name, H5T_NATIVE_INT64, space);
    checked(H5Awrite(attribute.get(), H5T_NATIVE_INT64, values.data()), "write the attribute " + name + " of");
}

// VTKHDF readers expect a string of fixed length.
void File::set_attribute(const std::string& object, const std::string& name, const std::string& text) {
    const std::string operation = "make the attribute " + name + " in";
    const Datatype type{checked(H5Tcopy(H5T_C_S1), operation)};
    checked(H5Tset_size(type.get(), text.size()), operation);
    checked(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), operation);
    const Dataspace space{checked(H5Screate(H5S_SCALAR), operation)};
    const Attribute attribute = create_attribute(object, name, type.get(), space);
    checked(H5Awrite(attribute.get(), type.get(), text.data()), "write the attribute " + name + " of");
}

std::vector<std::int64_t> File::integer_attribute(const std::string& object, const std::string& name) const {
    const std::string operation = "read the attribute " + name + " of";
    const Attribute attribute = open_attribute(object, name);
    const Dataspace space{checked(H5Aget_space(attribute.get()), operation)};
    std::vector<std::int64_t> values(
        static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space.get()), operation)));
    checked(H5Aread(attribute.get(), H5T_NATIVE_INT64, values.data()), operation);
    return values;
}

std::string File::text_attribute(const std::string& object, const std::string& name) const {
    const std::string operation = "read the attribute " + name + " of";
    const Attribute attribute = open_attribute(object, name);
    const Datatype type{checked(H5Aget_type(attribute.get()), operation)};
    std::string text(H5Tget_size(type.get()), '\0');
    checked(H5Aread(attribute.get(), type.get(), text.data()), operation);
    return text;
}

}  // namespace cracksim::io::hdf5
