#include "client/formats/zip_file.hpp"

#include "common/core/errors.hpp"

#include <zip.h>

#include <algorithm>

namespace cd {

namespace {

Error damaged() {
    return bad_input("is damaged");
}

} // namespace

void ZipEntry::Close::operator()(zip_file* file) const {
    zip_fclose(file);
}

void ZipFile::Close::operator()(zip* archive) const {
    zip_discard(archive);
}

Result<std::size_t> ZipEntry::read(std::span<std::byte> into) {
    const std::uint64_t wanted = std::min<std::uint64_t>(into.size(), size_ - done_);
    std::uint64_t count = 0;
    while (count < wanted) {
        const zip_int64_t got = zip_fread(file_.get(), into.data() + count, wanted - count);
        if (got <= 0) {
            return damaged();
        }
        count += static_cast<std::uint64_t>(got);
    }
    done_ += count;
    // Reading beyond the end makes libzip verify the checksum.
    std::byte beyond{};
    if (done_ == size_ && zip_fread(file_.get(), &beyond, 1) != 0) {
        return damaged();
    }
    return static_cast<std::size_t>(count);
}

Result<ZipFile> ZipFile::open(const std::filesystem::path& path) {
    int code = 0;
    ZipFile file;
    file.archive_.reset(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code));
    if (!file.archive_) {
        return code == ZIP_ER_NOENT ? Error{ErrorCode::NotFound, "no such file"}
                                    : bad_input("is not a zip archive");
    }
    const zip_int64_t count = zip_get_num_entries(file.archive_.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
        const char* const name = zip_get_name(file.archive_.get(), static_cast<zip_uint64_t>(i), 0);
        if (name == nullptr) {
            return bad_input("has a damaged directory");
        }
        file.names_.emplace_back(name);
    }
    return file;
}

Result<ZipEntry> ZipFile::entry(const std::string& name) const {
    zip_stat_t status;
    if (zip_stat(archive_.get(), name.c_str(), 0, &status) != 0) {
        return Error{ErrorCode::NotFound, "is not in the archive"};
    }
    // Refuses a false size before it is allocated: Deflate expands at most 1,032 times.
    constexpr std::uint64_t inflation_max = 1032;
    const bool is_known =
        status.comp_method == ZIP_CM_STORE || status.comp_method == ZIP_CM_DEFLATE;
    if (!is_known || status.size / inflation_max > status.comp_size) {
        return bad_input(is_known ? "is damaged" : "is packed by a method other than deflate");
    }
    ZipEntry entry;
    entry.file_.reset(zip_fopen(archive_.get(), name.c_str(), 0));
    entry.size_ = status.size;
    if (!entry.file_) {
        return damaged();
    }
    return entry;
}

} // namespace cd
