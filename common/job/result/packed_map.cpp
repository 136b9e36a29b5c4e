#include "common/job/result/packed_map.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Entries = std::vector<TriangleContacts>;

} // namespace

Bytes pack_map(const ContactMap& map) {
    ByteWriter out;
    for (const Entries& entries : map.bodies) {
        put_varint(out, entries.size());
        std::uint64_t next = 0;
        for (const TriangleContacts& entry : entries) {
            put_varint(out, entry.triangle - next);
            next = std::uint64_t{entry.triangle} + 1;
        }
        for (const TriangleContacts& entry : entries) {
            put_varint(out, entry.scenarios - 1);
        }
    }
    return compress(out.bytes(), compression_level_results);
}

namespace {

Error bad_map() {
    return {ErrorCode::BadFrame,
            "a map of contacts that contradicts itself, its bodies or its "
            "scenarios"};
}

/// Reads the entries of one body, whose mesh has `triangles` triangles. Returns nothing unless they
/// fit that mesh and no triangle has more than `scenarios` scenarios.
std::optional<Entries>
get_entries(ByteReader& in, std::uint64_t triangles, std::uint64_t scenarios) {
    const auto count = get_varint(in);
    if (!count || *count > triangles || *count > in.remaining() / 2) {
        return std::nullopt;
    }
    Entries entries;
    entries.reserve(*count);
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto step = get_varint(in);
        if (!step || *step >= triangles - next) {
            return std::nullopt;
        }
        next += *step;
        entries.push_back({static_cast<std::uint32_t>(next++), 0});
    }
    for (TriangleContacts& entry : entries) {
        const auto more = get_varint(in);
        if (!more || *more >= scenarios) {
            return std::nullopt;
        }
        entry.scenarios = *more + 1;
    }
    return entries;
}

} // namespace

Result<ContactMap> unpack_map(std::span<const std::byte> packed, const ContactMapBounds& bounds) {
    // A triangle's step takes at most 5 bytes, its count at most 6; a body's header at most 10.
    static_assert(limits::scenarios_max < std::uint64_t{1} << 42);
    const std::uint64_t bytes_max = 11 * (bounds.triangles_a + bounds.triangles_b) + 20;
    const Result<Bytes> bytes = decompress(packed, bytes_max);
    if (!bytes) {
        return bad_map();
    }
    ByteReader in(bytes.value());
    auto a = get_entries(in, bounds.triangles_a, bounds.scenarios);
    auto b = a ? get_entries(in, bounds.triangles_b, bounds.scenarios) : std::nullopt;
    if (!b || !in.complete()) {
        return bad_map();
    }
    return ContactMap{{std::move(*a), std::move(*b)}};
}

} // namespace cd
