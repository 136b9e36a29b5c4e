#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/geometry/mesh.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <cstring>
#include <string>

namespace cd::fuzz {

namespace {

void decode(std::uint16_t type, Input payload) {
    const auto decoded = decode_message(type, payload);
    if (decoded) {
        require(message_type(decoded.value()) == type, "a message has the type it came as");
        const Bytes again = encode_message(decoded.value());
        const auto* hello = std::get_if<Hello>(&decoded.value());
        const bool is_foreign = hello != nullptr && hello->version != protocol_version;
        if (!is_foreign) {
            require_canonical(again, payload);
        }
    }
}

/// True if an accepted input had a minus zero whose sign byte the encoder drops.
bool differ_in_signs_of_zeros(Input input, Input written) {
    return input.size() == written.size() &&
           std::ranges::equal(input, written, [](std::byte was, std::byte is) {
               return was == is || (was == std::byte{0x80} && is == std::byte{0});
           });
}

} // namespace

/// The input is a header, then for each frame: type (a byte), a byte whose lowest bit means more to
/// come and whose others are the stream, length (two bytes), payload. The target adds checksums,
/// which no fuzzer would guess.
void frames(Input input) {
    if (input.size() < frame_header_bytes) {
        return;
    }
    const auto header = decode_header(input.first<frame_header_bytes>());
    if (header) {
        require_canonical(encode_header(header.value()), input.first(frame_header_bytes));
    }
    MessageAssembler assembler;
    ByteReader in(input.subspan(frame_header_bytes));
    while (!in.failed() && in.remaining() != 0) {
        FrameHeader frame;
        frame.type = in.get<std::uint8_t>();
        const auto rest = in.get<std::uint8_t>();
        frame.has_more = (rest & 1u) != 0;
        frame.stream = rest >> 1u;
        const auto length = in.get<std::uint16_t>();
        if (in.failed()) {
            return;
        }
        const Input payload = in.get_bytes(std::min<std::size_t>(length, in.remaining()));
        frame.payload_bytes = static_cast<std::uint32_t>(payload.size());
        frame.payload_checksum = checksum(payload);
        const auto added = assembler.add(frame, payload);
        if (!added) {
            return;
        }
        if (added.value()) {
            require(added.value()->payload.size() <= payload_bytes_max(added.value()->type),
                    "no message is larger than its type allows");
            decode(added.value()->type, added.value()->payload);
        }
    }
}

void message(Input input) {
    std::uint16_t type = 0;
    if (input.size() < sizeof type) {
        return;
    }
    std::memcpy(&type, input.data(), sizeof type);
    decode(type, input.subspan(sizeof type));
}

void token(Input input) {
    const std::string text = text_of(input);
    const auto read = parse_join_token(text);
    if (read) {
        require(parse_join_token(to_text(read.value())).has_value(), "a token's text is one");
    }
}

void mesh(Input input) {
    const auto decoded = Mesh::from_canonical_bytes(input);
    if (!decoded) {
        return;
    }
    const Mesh& mesh = decoded.value();
    const Bytes written = mesh.canonical_bytes();
    require(sha256(written) == mesh.hash(), "a mesh has the hash of its bytes");
    require(differ_in_signs_of_zeros(input, written), "what is accepted is what is written");
    for (std::uint32_t triangle = 0; triangle < mesh.triangles().size(); ++triangle) {
        for (const std::uint32_t vertex : mesh.triangles()[triangle]) {
            require(vertex < mesh.vertices().size(), "a triangle's corners are there");
        }
        for (const Vec3& corner : mesh.corners(triangle)) {
            require(corner.allFinite(), "a triangle's corners are finite");
        }
    }
    for (const Part& part : mesh.parts()) {
        require(part.triangles_begin <= part.triangles_end &&
                    part.triangles_end <= mesh.triangles().size(),
                "a part's triangles are there");
    }
}

} // namespace cd::fuzz
