#include "client/formats/npz.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"

#include <zip.h>

#include <memory>
#include <system_error>

namespace cd {

namespace {

/// A stream takes about as long for an element as for a thousand.
constexpr std::size_t spooled_at_once = 1u << 16;

struct CloseArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};

} // namespace

NpzWriter::~NpzWriter() {
    remove_spools();
}

void NpzWriter::remove_spools() {
    for (Array& array : arrays_) {
        array.file.close();
        std::error_code ignored;
        std::filesystem::remove(array.spool, ignored);
    }
}

std::size_t NpzWriter::add_array(const ArrayLayout& layout) {
    Array array{layout};
    array.spool = path().string() + "." + std::to_string(arrays_.size()) + ".part";
    array.file.open(array.spool, std::ios::binary | std::ios::trunc);
    // Leaves room for the header, which `finish` writes once the length is known.
    const Bytes room(npy_header_bytes);
    array.file.write(reinterpret_cast<const char*>(room.data()), npy_header_bytes);
    arrays_.push_back(std::move(array));
    return arrays_.size() - 1;
}

Status
NpzWriter::append_bytes(std::size_t array, std::span<const std::byte> bytes, std::size_t item) {
    Array& target = arrays_[array];
    CD_CHECK(item == size_of(target.layout.type));
    target.waiting.insert(target.waiting.end(), bytes.begin(), bytes.end());
    target.elements += bytes.size() / item;
    const bool may_wait = target.file && target.waiting.size() < spooled_at_once;
    return may_wait ? Status(Done{}) : spool(target);
}

/// Writes the elements that wait. Fails if the file could not be created, too.
Status NpzWriter::spool(Array& array) const {
    array.file.write(reinterpret_cast<const char*>(array.waiting.data()),
                     static_cast<std::streamsize>(array.waiting.size()));
    array.waiting.clear();
    if (!array.file) {
        return cannot_write("no room, or no right, for " + array.spool.string());
    }
    return Done{};
}

Status NpzWriter::finish() {
    int code = 0;
    std::unique_ptr<zip_t, CloseArchive> archive(
        zip_open(temporary_path().c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
    if (!archive) {
        return cannot_write("the folder is missing or may not be written to");
    }
    for (Array& array : arrays_) {
        CD_TRY(spool(array));
        const Bytes header =
            make_npy_header(array.layout.type, array.layout.shape_of(array.elements));
        array.file.seekp(0);
        array.file.write(reinterpret_cast<const char*>(header.data()), npy_header_bytes);
        array.file.close();
        if (!array.file) {
            return cannot_write("no room, or no right, for " + array.spool.string());
        }
        zip_source_t* source = zip_source_file(archive.get(), array.spool.c_str(), 0, -1);
        const zip_int64_t index = source == nullptr
                                      ? -1
                                      : zip_file_add(archive.get(),
                                                     (array.layout.name + ".npy").c_str(),
                                                     source,
                                                     ZIP_FL_ENC_UTF_8);
        if (index < 0) {
            zip_source_free(source);
            return cannot_write(zip_strerror(archive.get()));
        }
        zip_set_file_compression(
            archive.get(), static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 1);
        // Each file gets the time 1 January 1980, so that equal arrays make equal files.
        zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(index), 0, 0x21, 0);
    }
    zip_register_cancel_callback_with_state(
        archive.get(),
        [](zip_t*, void* writer) { return static_cast<NpzWriter*>(writer)->is_stopped() ? 1 : 0; },
        nullptr,
        this);
    if (zip_close(archive.get()) != 0) {
        if (is_stopped()) {
            return interrupted();
        }
        return cannot_write(zip_strerror(archive.get()));
    }
    static_cast<void>(archive.release()); // zip_close has freed it.
    CD_TRY(commit());
    remove_spools();
    return Done{};
}

} // namespace cd
