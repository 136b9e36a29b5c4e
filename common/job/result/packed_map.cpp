#include "common/job/result/packed_map.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/varint.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

namespace {

constexpr int compression_level = 3;
constexpr std::uint64_t flag_proper = 1;
constexpr std::uint64_t flag_near = 2;

// ---- Writing ------------------------------------------------------------------------------------

/// Writes triangles, or parts; `number` is the member with the number.
template <class Entry>
void put_entries(ByteWriter& out, const std::vector<Entry>& entries, std::uint32_t Entry::*number) {
    put_varint(out, entries.size());
    std::uint64_t next = 0;
    for (const Entry& entry : entries) {
        put_varint(out, entry.*number - next);
        next = std::uint64_t{entry.*number} + 1;
    }
    for (const Entry& entry : entries) {
        put_varint(out, entry.scenarios - 1);
    }
}

void put_pairs(ByteWriter& out, const std::vector<PartPairContacts>& pairs) {
    put_varint(out, pairs.size());
    std::uint64_t a = 0;
    std::uint64_t next_b = 0;
    for (const PartPairContacts& pair : pairs) {
        put_varint(out, pair.a - a);
        put_varint(out, pair.b - (pair.a == a ? next_b : 0));
        a = pair.a;
        next_b = std::uint64_t{pair.b} + 1;
        put_varint(out, pair.scenarios - 1);
        put_varint(out, pair.pairs + pair.near - pair.scenarios);
        put_varint(out, pair.worst_pairs + pair.worst_near - 1);
        put_varint(out, pair.first);
        put_varint(out, pair.worst - pair.first);
        put_varint(out, pair.last - pair.first);
        put_varint(out, (pair.has_proper ? flag_proper : 0) | (pair.near > 0 ? flag_near : 0));
        if (pair.near > 0) {
            put_varint(out, pair.near - 1);
            put_varint(out, pair.worst_near);
        }
    }
}

} // namespace

Bytes pack_map(const ContactMap& map) {
    ByteWriter out;
    for (const auto& triangles : map.bodies) {
        put_entries(out, triangles, &TriangleContacts::triangle);
    }
    for (const auto& parts : map.parts.parts) {
        put_entries(out, parts, &PartScenarios::part);
    }
    put_pairs(out, map.parts.pairs);
    put_varint(out, map.parts.left_out);
    return compress(out.bytes(), compression_level);
}

// ---- Reading ------------------------------------------------------------------------------------

namespace {

Error bad_map() {
    return {ErrorCode::BadFrame,
            "a map of contacts that contradicts itself, its bodies or its "
            "scenarios"};
}

/// Reads the entries of one body, which has `count_max` triangles or parts. Returns nothing unless
/// they fit that body and none has more than `scenarios` scenarios.
template <class Entry>
std::optional<std::vector<Entry>>
get_entries(ByteReader& in, std::uint64_t count_max, std::uint64_t scenarios) {
    const auto count = get_varint(in);
    if (!count || *count > count_max || *count > in.remaining() / 2) {
        return std::nullopt;
    }
    std::vector<Entry> entries;
    entries.reserve(*count);
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto step = get_varint(in);
        if (!step || *step >= count_max - next) {
            return std::nullopt;
        }
        next += *step;
        entries.push_back({static_cast<std::uint32_t>(next++), 0});
    }
    for (Entry& entry : entries) {
        const auto more = get_varint(in);
        if (!more || *more >= scenarios) {
            return std::nullopt;
        }
        entry.scenarios = *more + 1;
    }
    return entries;
}

/// Reads numbers up to the first one that is missing or above its bound.
class NumberReader {
  public:
    explicit NumberReader(ByteReader& in) : in_(in) {}

    /// Returns a number of at most `most`; 0 after a failure.
    std::uint64_t get(std::uint64_t most = UINT64_MAX) {
        const auto number = has_failed_ ? std::nullopt : get_varint(in_);
        has_failed_ = !number || *number > most;
        return has_failed_ ? 0 : *number;
    }
    [[nodiscard]] bool has_failed() const { return has_failed_; }

  private:
    ByteReader& in_;
    bool has_failed_ = false;
};

/// Reads which of the pairs of triangles are near, after `pairs` and `worst_pairs` were read as the
/// numbers of all. Returns false for numbers that contradict each other.
bool get_near(NumberReader& in, PartPairContacts& pair) {
    const std::uint64_t flags = in.get(flag_proper | flag_near);
    pair.has_proper = (flags & flag_proper) != 0;
    if ((flags & flag_near) != 0) {
        pair.near = in.get(pair.pairs - 1) + 1;
        pair.worst_near = in.get(std::min(pair.near, pair.worst_pairs));
        pair.pairs -= pair.near;
        pair.worst_pairs -= pair.worst_near;
    }
    const auto has_most = [&](std::uint64_t all, std::uint64_t most) {
        return most <= all && (all == 0 || (all - 1) / pair.scenarios < most);
    };
    return has_most(pair.pairs, pair.worst_pairs) &&
           (pair.pairs > 0 || has_most(pair.near, pair.worst_near)) &&
           (pair.pairs > 0 || !pair.has_proper);
}

/// Reads what is counted of a pair of parts. Returns false for numbers that contradict each other.
bool get_counts(NumberReader& in, std::uint64_t scenarios, PartPairContacts& pair) {
    if (scenarios == 0) {
        return false;
    }
    pair.scenarios = in.get(scenarios - 1) + 1;
    const std::uint64_t more_pairs = in.get(UINT64_MAX - pair.scenarios);
    pair.pairs = pair.scenarios + more_pairs;
    pair.worst_pairs = in.get(more_pairs) + 1;
    pair.first = in.get(limits::scenarios_max - 1);
    const std::uint64_t after = limits::scenarios_max - 1 - pair.first;
    const std::uint64_t worst = in.get(after);
    const std::uint64_t last = in.get(after);
    pair.worst = pair.first + worst;
    pair.last = pair.first + last;
    return get_near(in, pair) && !in.has_failed() && worst <= last && last >= pair.scenarios - 1;
}

std::optional<std::vector<PartPairContacts>> get_pairs(ByteReader& bytes, std::uint64_t scenarios) {
    NumberReader in(bytes);
    const std::uint64_t count =
        in.get(std::min<std::uint64_t>(limits::groups_max, bytes.remaining()));
    std::vector<PartPairContacts> pairs;
    std::uint64_t a = 0;
    std::uint64_t next_b = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t step = in.get(limits::parts_max - a);
        a += step;
        next_b = step == 0 ? next_b : 0;
        if (next_b > limits::parts_max) {
            return std::nullopt;
        }
        PartPairContacts pair;
        pair.a = static_cast<std::uint32_t>(a);
        pair.b = static_cast<std::uint32_t>(next_b + in.get(limits::parts_max - next_b));
        next_b = std::uint64_t{pair.b} + 1;
        if (!get_counts(in, scenarios, pair)) {
            return std::nullopt;
        }
        pairs.push_back(pair);
    }
    return in.has_failed() ? std::nullopt : std::optional(std::move(pairs));
}

std::optional<PartContacts> get_parts(ByteReader& in, std::uint64_t scenarios) {
    PartContacts contacts;
    for (auto& parts : contacts.parts) {
        auto entries = get_entries<PartScenarios>(in, limits::parts_max + 1, scenarios);
        if (!entries) {
            return std::nullopt;
        }
        parts = std::move(*entries);
    }
    auto pairs = get_pairs(in, scenarios);
    const auto left_out = pairs ? get_varint(in) : std::nullopt;
    if (!left_out || (*left_out != 0 && !pairs->empty())) {
        return std::nullopt;
    }
    contacts.pairs = std::move(*pairs);
    contacts.left_out = *left_out;
    return contacts;
}

/// A bound on the bytes of the sums by part: a part's step takes at most 3 bytes, its count 6, and
/// each of the eleven numbers of a pair of parts 10.
constexpr std::uint64_t parts_bytes_max =
    2 * 9 * (std::uint64_t{limits::parts_max} + 1) + 110 * limits::groups_max + 40;

} // namespace

Result<ContactMap> unpack_map(std::span<const std::byte> packed, const ContactMapBounds& bounds) {
    // A triangle's step takes at most 5 bytes, its count at most 6; a body's header at most 10.
    static_assert(limits::scenarios_max < std::uint64_t{1} << 42 &&
                  limits::map_crossings_max <= std::uint64_t{1} << 42);
    const std::uint64_t bytes_max =
        11 * (bounds.triangles_a + bounds.triangles_b) + 20 + parts_bytes_max;
    const Result<Bytes> bytes = decompress(packed, bytes_max);
    if (!bytes) {
        return bad_map();
    }
    ByteReader in(bytes.value());
    const std::uint64_t most = std::max(bounds.scenarios, bounds.crossings);
    auto a = get_entries<TriangleContacts>(in, bounds.triangles_a, most);
    auto b = a ? get_entries<TriangleContacts>(in, bounds.triangles_b, most) : std::nullopt;
    auto parts = b ? get_parts(in, bounds.scenarios) : std::nullopt;
    if (!parts || !in.complete()) {
        return bad_map();
    }
    return ContactMap{{std::move(*a), std::move(*b)}, std::move(*parts)};
}

} // namespace cd
