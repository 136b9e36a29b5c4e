#include "client/formats/gzip.hpp"

#include "common/core/check.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace cd {

namespace {

constexpr int gzip_window_bits = 15 + 16;   ///< The largest window, and the header of gzip.
constexpr int memory_level = 8;             ///< The default of zlib.
constexpr std::size_t input_max = 1u << 30; ///< zlib counts in 32 bits.

} // namespace

Bytes gzip(std::span<const std::byte> bytes) {
    z_stream stream{};
    CD_CHECK(deflateInit2(&stream,
                          Z_DEFAULT_COMPRESSION,
                          Z_DEFLATED,
                          gzip_window_bits,
                          memory_level,
                          Z_DEFAULT_STRATEGY) == Z_OK);
    Bytes packed;
    std::array<std::byte, 1u << 16> piece{};
    int state = Z_OK;
    while (state != Z_STREAM_END) {
        if (stream.avail_in == 0) {
            const auto input = bytes.first(std::min(bytes.size(), input_max));
            // zlib only reads its input, though the type does not say so.
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(input.data()));
            stream.avail_in = static_cast<uInt>(input.size());
            bytes = bytes.subspan(input.size());
        }
        stream.next_out = reinterpret_cast<Bytef*>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
        CD_CHECK(state == Z_OK || state == Z_STREAM_END);
        const auto written = std::span(piece).first(piece.size() - stream.avail_out);
        packed.insert(packed.end(), written.begin(), written.end());
    }
    deflateEnd(&stream);
    return packed;
}

} // namespace cd
