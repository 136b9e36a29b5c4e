#include "common/core/compress.hpp"

#include "common/core/check.hpp"

#include <zstd.h>

#include <algorithm>
#include <memory>

namespace cd {

Bytes compress(std::span<const std::byte> bytes, int level) {
    Bytes out(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level);
    CD_CHECK(ZSTD_isError(size) == 0);
    out.resize(size);
    return out;
}

Result<Bytes> decompress(std::span<const std::byte> bytes, std::size_t size_max) {
    const unsigned long long claimed = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
    if (claimed == ZSTD_CONTENTSIZE_ERROR || claimed == ZSTD_CONTENTSIZE_UNKNOWN) {
        return Error{ErrorCode::BadFrame, "compressed data without a readable size"};
    }
    if (claimed > size_max) {
        return Error{ErrorCode::TooLarge,
                     "compressed data claims " + std::to_string(claimed) + " bytes, at most " +
                         std::to_string(size_max) + " are allowed"};
    }
    if (ZSTD_findFrameCompressedSize(bytes.data(), bytes.size()) != bytes.size()) {
        return Error{ErrorCode::BadFrame, "compressed data is cut short or has bytes left over"};
    }
    Bytes out(static_cast<std::size_t>(claimed));
    const std::size_t size = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
    if (ZSTD_isError(size) != 0 || size != out.size()) {
        return Error{ErrorCode::BadFrame, "compressed data is damaged"};
    }
    return out;
}

} // namespace cd
