#include "common/core/files/compress.hpp"

#include "common/core/check.hpp"

#include <zstd.h>

#include <algorithm>
#include <memory>

namespace cd {

namespace {

// Each thread keeps its contexts: to make one costs more than to compress a few kilobytes.
struct FreeContext {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

ZSTD_CCtx* compressing_context() {
    thread_local const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
    CD_CHECK(context != nullptr);
    return context.get();
}

ZSTD_DCtx* decompressing_context() {
    thread_local const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
    CD_CHECK(context != nullptr);
    return context.get();
}

} // namespace

Bytes compress(std::span<const std::byte> bytes, int level) {
    Bytes out(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compressCCtx(
        compressing_context(), out.data(), out.size(), bytes.data(), bytes.size(), level);
    CD_CHECK(ZSTD_isError(size) == 0);
    out.resize(size);
    return out;
}

namespace {

/// Claimed compression ratio up to which `decompress` allocates the whole output at once. Above
/// this ratio only pages that are written cost memory, and the output is copied once more.
constexpr std::size_t believed_ratio = 64;

/// Decompresses into `out`. Returns false if `bytes` are damaged or do not fill `out` exactly.
bool decompress_into(std::span<std::byte> out, std::span<const std::byte> bytes) {
    return ZSTD_decompressDCtx(
               decompressing_context(), out.data(), out.size(), bytes.data(), bytes.size()) ==
           out.size();
}

} // namespace

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
    const Error damaged{ErrorCode::BadFrame, "compressed data is damaged"};
    if (ZSTD_findFrameCompressedSize(bytes.data(), bytes.size()) != bytes.size()) {
        return Error{ErrorCode::BadFrame, "compressed data is cut short or has bytes left over"};
    }
    const auto size = static_cast<std::size_t>(claimed);
    if (size <= believed_ratio * bytes.size()) {
        Bytes out(size);
        return decompress_into(out, bytes) ? Result<Bytes>(std::move(out)) : Result<Bytes>(damaged);
    }
    // Pages of uninitialised memory take no RAM until they are written.
    const auto unwritten = std::make_unique_for_overwrite<std::byte[]>(size);
    const std::span<std::byte> out(unwritten.get(), size);
    return decompress_into(out, bytes) ? Result<Bytes>(Bytes(out.begin(), out.end()))
                                       : Result<Bytes>(damaged);
}

} // namespace cd
