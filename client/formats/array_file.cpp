#include "client/formats/array_file.hpp"

#include "client/formats/h5.hpp"
#include "client/formats/npz.hpp"
#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace cd {

std::vector<std::uint64_t> ArrayLayout::shape_of(std::uint64_t elements) const {
    if (columns == 0) {
        return {elements};
    }
    const std::uint64_t rows = elements / columns;
    return rows_each == 1 ? std::vector<std::uint64_t>{rows, columns}
                          : std::vector<std::uint64_t>{rows / rows_each, rows_each, columns};
}

Error ArrayFile::cannot_write(const std::string& why) const {
    return {ErrorCode::Io, path_.string() + ": cannot be written: " + why};
}

Status ArrayFile::commit() const {
    const auto written = DiskFile::open(temporary_path());
    const Status synced = written ? written.value().sync() : written.error();
    if (!synced) {
        return cannot_write(synced.error().detail);
    }
    std::error_code error;
    std::filesystem::rename(temporary_path(), path_, error);
    return error ? Status(cannot_write(error.message())) : Status(Done{});
}

bool is_array_format(std::string_view format) {
    return std::ranges::find(array_formats, format) != array_formats.end();
}

std::unique_ptr<ArrayFile> make_array_file(std::string_view format,
                                           const std::filesystem::path& dir,
                                           std::string_view stem,
                                           StopCheck stop) {
    CD_CHECK(is_array_format(format));
    const std::filesystem::path path = dir / (std::string(stem) + "." + std::string(format));
    if (format == "h5") {
        return std::make_unique<H5Writer>(path);
    }
    return std::make_unique<NpzWriter>(path, std::move(stop));
}

} // namespace cd
