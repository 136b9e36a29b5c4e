#include "client/formats/array_spool.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t buffer_bytes = 1u << 16;

} // namespace

Result<ArraySpool> ArraySpool::create(const std::filesystem::path& path, NpyType type) {
    auto file = CD_TRY(DiskFile::create_for(path));
    return ArraySpool(std::move(file), type);
}

Status ArraySpool::append_bytes(std::span<const std::byte> bytes) {
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return buffer_.size() < buffer_bytes ? Status(Done{}) : flush();
}

Status ArraySpool::flush() {
    CD_TRY(file_->write_at(bytes_written_, buffer_));
    bytes_written_ += buffer_.size();
    buffer_.clear();
    return Done{};
}

Result<NumberArray> ArraySpool::finish() {
    CD_TRY(flush());
    const auto produce = [file = file_.get(),
                          size = bytes_written_](const ByteSink& sink) -> Status {
        for (std::uint64_t offset = 0; offset < size; offset += buffer_bytes) {
            const Bytes piece =
                CD_TRY(file->read_at(offset, std::min<std::uint64_t>(buffer_bytes, size - offset)));
            CD_TRY(sink(piece));
        }
        return Done{};
    };
    return NumberArray{type_, bytes_written_ / size_of(type_), produce};
}

} // namespace cd
