#include "client/formats/h5.hpp"

#include "common/core/check.hpp"

#include <hdf5.h>

#include <algorithm>
#include <mutex>
#include <system_error>
#include <utility>

namespace cd {

namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// About so many bytes of an array are compressed together. Readers decompress whole chunks, and
/// the library caches up to 1 MiB of an array.
constexpr std::uint64_t chunk_bytes = 1u << 18;
constexpr unsigned deflate_level = 1; ///< As in the zip of an NPZ.

/// Serialises calls of the library, whose state is global.
std::mutex& library_mutex() {
    static std::mutex mutex;
    return mutex;
}

/// An object of the library.
class Handle {
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (id_ >= 0) {
            close_(id_);
        }
    }

    [[nodiscard]] hid_t id() const { return id_; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Returns the library's type, which all hosts have in memory as well: they are little-endian.
hid_t type_of(NpyType type) {
    switch (type) {
    case NpyType::F8:
        return H5T_IEEE_F64LE;
    case NpyType::F4:
        return H5T_IEEE_F32LE;
    case NpyType::I8:
        return H5T_STD_I64LE;
    case NpyType::I4:
        return H5T_STD_I32LE;
    case NpyType::I2:
        return H5T_STD_I16LE;
    case NpyType::I1:
        return H5T_STD_I8LE;
    case NpyType::U8:
        return H5T_STD_U64LE;
    case NpyType::U4:
        return H5T_STD_U32LE;
    case NpyType::U2:
        return H5T_STD_U16LE;
    case NpyType::U1:
        return H5T_STD_U8LE;
    }
    return -1;
}

std::vector<hsize_t> dimensions_of(const ArrayLayout& layout, std::uint64_t elements) {
    const std::vector<std::uint64_t> shape = layout.shape_of(elements);
    return {shape.begin(), shape.end()};
}

hid_t create_file(const std::filesystem::path& path) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // Errors are returned, not printed.
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Nobody else knows the temporary name, and some shared file systems have no locks.
    H5Pset_file_locking(access.id(), 0, 1);
    return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id());
}

hid_t create_array(hid_t file, const ArrayLayout& layout, std::uint64_t chunk_rows) {
    std::vector<hsize_t> chunk = dimensions_of(layout, 0);
    chunk.front() = chunk_rows;
    std::vector<hsize_t> now = chunk;
    now.front() = 0;
    std::vector<hsize_t> most = chunk;
    most.front() = H5S_UNLIMITED;
    const auto rank = static_cast<int>(chunk.size());
    const Handle space(H5Screate_simple(rank, now.data(), most.data()), H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(creation.id(), rank, chunk.data());
    H5Pset_shuffle(creation.id());
    H5Pset_deflate(creation.id(), deflate_level);
    H5Pset_obj_track_times(creation.id(), 0); // So that equal arrays make equal files.
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links.id(), 1);
    return H5Dcreate2(file,
                      layout.name.c_str(),
                      type_of(layout.type),
                      space.id(),
                      links.id(),
                      creation.id(),
                      H5P_DEFAULT);
}

} // namespace

H5Writer::H5Writer(std::filesystem::path path) : ArrayFile(std::move(path)) {
    const std::lock_guard lock(library_mutex());
    file_ = create_file(temporary_path());
}

H5Writer::~H5Writer() {
    const std::lock_guard lock(library_mutex());
    static_cast<void>(close());
    std::error_code ignored;
    std::filesystem::remove(temporary_path(), ignored);
}

/// Closes all arrays and the file. Returns false if the library could not write all of it.
bool H5Writer::close() {
    bool is_good = true;
    for (Array& array : arrays_) {
        is_good = (array.id < 0 || H5Dclose(array.id) >= 0) && is_good;
        array.id = -1;
    }
    is_good = (file_ < 0 || H5Fclose(file_) >= 0) && is_good;
    file_ = -1;
    return is_good;
}

std::size_t H5Writer::add_array(const ArrayLayout& layout) {
    const std::lock_guard lock(library_mutex());
    Array array{layout};
    array.row_bytes = size_of(layout.type) * std::max<std::uint64_t>(layout.columns, 1) *
                      std::max<std::uint64_t>(layout.rows_each, 1);
    array.chunk_rows = std::max<std::uint64_t>(chunk_bytes / array.row_bytes, 1);
    if (file_ >= 0) {
        array.id = create_array(file_, layout, array.chunk_rows);
    }
    arrays_.push_back(std::move(array));
    return arrays_.size() - 1;
}

/// Writes the whole rows that wait.
Status H5Writer::write_rows(Array& array) const {
    const std::uint64_t rows = array.waiting.size() / array.row_bytes;
    if (rows == 0) {
        return Done{};
    }
    const ArrayLayout& layout = array.layout;
    const std::uint64_t elements = rows * array.row_bytes / size_of(layout.type);
    std::vector<hsize_t> first = dimensions_of(layout, array.elements);
    const std::vector<hsize_t> now = dimensions_of(layout, array.elements + elements);
    const std::vector<hsize_t> count = dimensions_of(layout, elements);
    std::fill(first.begin() + 1, first.end(), 0);
    const bool is_extended = H5Dset_extent(array.id, now.data()) >= 0;
    const Handle from(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                      H5Sclose);
    const Handle to(H5Dget_space(array.id), H5Sclose);
    const bool is_written =
        is_extended &&
        H5Sselect_hyperslab(
            to.id(), H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr) >= 0 &&
        H5Dwrite(array.id,
                 type_of(layout.type),
                 from.id(),
                 to.id(),
                 H5P_DEFAULT,
                 array.waiting.data()) >= 0;
    if (!is_written) {
        return cannot_write("no room for the array " + layout.name);
    }
    array.elements += elements;
    array.waiting.erase(array.waiting.begin(),
                        array.waiting.begin() +
                            static_cast<std::ptrdiff_t>(rows * array.row_bytes));
    return Done{};
}

Status
H5Writer::append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item) {
    Array& target = arrays_[array];
    CD_CHECK(item == size_of(target.layout.type));
    if (file_ < 0) {
        return cannot_write("the folder is missing or may not be written to");
    }
    if (target.id < 0) {
        return cannot_write("HDF5 does not take the name '" + target.layout.name +
                            "' for an array");
    }
    const std::uint64_t most = target.chunk_rows * target.row_bytes;
    while (!bytes.empty()) {
        const std::size_t taken = std::min<std::size_t>(bytes.size(), most - target.waiting.size());
        target.waiting.insert(target.waiting.end(), bytes.begin(), bytes.begin() + taken);
        bytes = bytes.subspan(taken);
        if (target.waiting.size() == most) {
            const std::lock_guard lock(library_mutex());
            if (Status written = write_rows(target); !written) {
                return written;
            }
        }
    }
    return Done{};
}

Status H5Writer::finish() {
    {
        const std::lock_guard lock(library_mutex());
        for (Array& array : arrays_) {
            if (Status written = write_rows(array); !written) {
                return written;
            }
        }
        if (!close()) {
            return cannot_write("no room for all of it");
        }
    }
    return commit();
}

} // namespace cd
