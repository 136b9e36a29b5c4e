#include "common/job/result/result.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace cd {

namespace {

constexpr std::uint8_t version = 2;
constexpr std::uint8_t flag_surfaces_only = 1;
constexpr std::uint8_t flag_insides_skipped = 2;
constexpr std::size_t head_bytes = 28;
constexpr std::uint64_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;
constexpr std::uint64_t point_bytes = 3 * sizeof(double);
/// The intersection of two triangles is at most a hexagon.
constexpr std::uint32_t points_of_pair_max = 6;

constexpr std::array<std::string_view, 7> class_names{
    "separate", "touch", "cross", "inside", "contact", "undecided", "failed"};

/// Returns the number in a canonical bit pattern: zero has no sign, and NaN (a point that left the
/// range of double) has no payload.
double canonical(double value) {
    return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
}

bool is_canonical(double value) {
    return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(canonical(value));
}

void put_points(ByteWriter& out, std::span<const Vec3> points) {
    std::vector<double> values;
    values.reserve(3 * points.size());
    for (const Vec3& point : points) {
        for (int i = 0; i < 3; ++i) {
            values.push_back(canonical(point[i]));
        }
    }
    out.put_array(std::span<const double>(values));
}

void put_pairs(ByteWriter& out, std::span<const ContactPair> pairs) {
    std::vector<std::uint32_t> triangles(2 * pairs.size());
    std::vector<std::uint8_t> kinds(pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        triangles[i] = pairs[i].a;
        triangles[pairs.size() + i] = pairs[i].b;
        kinds[i] = static_cast<std::uint8_t>(pairs[i].kind);
    }
    out.put_array(std::span<const std::uint32_t>(triangles));
    out.put_array(std::span<const std::uint8_t>(kinds));
}

void put_shared_points(ByteWriter& out, const ScenarioResult& result) {
    const std::size_t pairs = result.pairs.size();
    CD_CHECK(result.point_origins.size() == pairs);
    CD_CHECK(result.point_offsets.size() == pairs + 1);
    CD_CHECK(result.point_offsets.back() == result.points.size());
    for (std::size_t i = 0; i < pairs; ++i) {
        const std::uint32_t count = result.point_offsets[i + 1] - result.point_offsets[i];
        CD_CHECK(count <= points_of_pair_max);
        out.put(static_cast<std::uint8_t>(count));
    }
    put_points(out, result.point_origins);
    put_points(out, result.points);
}

/// Returns the exact number of bytes of a record.
std::uint64_t bytes_of_record(const ScenarioResult& result) {
    const std::uint64_t bound = result.kind == ScenarioClass::Undecided ? sizeof(double) : 0;
    if (result.kind == ScenarioClass::Failed) {
        return head_bytes + sizeof(std::uint32_t) + result.failure.size();
    }
    if (result.level < Level::Pairs) {
        return head_bytes + bound;
    }
    const std::uint64_t pairs = sizeof(std::uint32_t) + pair_bytes * result.pairs.size();
    const std::uint64_t points =
        result.level < Level::Contacts
            ? 0
            : result.pairs.size() + point_bytes * (result.pairs.size() + result.points.size());
    return head_bytes + bound + pairs + points;
}

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

/// Writes the head of a record in one piece, for speed: at `level count` the head is the whole
/// record, and the master writes a million records per second.
void put_head(ByteWriter& out, const ScenarioResult& result) {
    std::array<std::uint8_t, head_bytes> head;
    std::uint8_t* to = head.data();
    const auto put = [&](auto value) {
        std::memcpy(to, &value, sizeof value);
        to += sizeof value;
    };
    put(version);
    put(result.index);
    put(result.body_a);
    put(result.body_b);
    put(static_cast<std::uint8_t>(result.level));
    put(static_cast<std::uint8_t>(result.kind));
    put(static_cast<std::uint8_t>((result.surfaces_only ? flag_surfaces_only : 0) |
                                  (result.insides_skipped ? flag_insides_skipped : 0)));
    put(result.pair_count);
    CD_CHECK(to == head.data() + head.size());
    out.put_array(std::span<const std::uint8_t>(head));
}

/// Writes a record without its length.
void put_body(ByteWriter& out, const ScenarioResult& result) {
    put_head(out, result);
    if (result.kind == ScenarioClass::Undecided) {
        out.put(canonical(result.distance_bound));
    }
    if (result.kind == ScenarioClass::Failed) {
        out.put_text(result.failure);
        return;
    }
    if (result.level >= Level::Pairs) {
        CD_CHECK(result.pairs.size() <= UINT32_MAX);
        out.put(static_cast<std::uint32_t>(result.pairs.size()));
        put_pairs(out, result.pairs);
    }
    if (result.level >= Level::Contacts) {
        put_shared_points(out, result);
    }
}

Status get_head(ByteReader& in, ScenarioResult& result) {
    if (in.get<std::uint8_t>() != version) {
        return bad("unknown version");
    }
    result.index = in.get<std::uint64_t>();
    result.body_a = in.get<std::uint32_t>();
    result.body_b = in.get<std::uint32_t>();
    const auto level = in.get<std::uint8_t>();
    const auto kind = in.get<std::uint8_t>();
    const auto flags = in.get<std::uint8_t>();
    result.pair_count = in.get<std::uint64_t>();
    if (in.failed()) {
        return bad("cut short");
    }
    if (level > static_cast<std::uint8_t>(Level::Contacts) ||
        kind > static_cast<std::uint8_t>(ScenarioClass::Failed) || flags > flag_insides_skipped) {
        return bad("unknown level, class or flag");
    }
    result.level = static_cast<Level>(level);
    result.kind = static_cast<ScenarioClass>(kind);
    result.surfaces_only = (flags & flag_surfaces_only) != 0;
    result.insides_skipped = (flags & flag_insides_skipped) != 0;
    if (result.kind == ScenarioClass::Undecided) {
        result.distance_bound = in.get<double>();
        if (in.failed() || !(result.distance_bound >= 0) || !is_canonical(result.distance_bound)) {
            return bad("a bound that is no distance");
        }
    }
    return Done{};
}

Status get_pairs(ByteReader& in, ScenarioResult& result) {
    const auto count = in.get<std::uint32_t>();
    const auto a = in.get_array<std::uint32_t>(count);
    const auto b = in.get_array<std::uint32_t>(count);
    const auto kinds = in.get_array<std::uint8_t>(count);
    if (in.failed()) {
        return bad("pairs cut short");
    }
    result.pairs.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (kinds[i] < static_cast<std::uint8_t>(PairClass::Touch) ||
            kinds[i] > static_cast<std::uint8_t>(PairClass::Proper)) {
            return bad("unknown class of a pair");
        }
        if (i > 0 && !(std::pair(a[i - 1], b[i - 1]) < std::pair(a[i], b[i]))) {
            return bad("pairs are not strictly ascending");
        }
        result.pairs.push_back({a[i], b[i], static_cast<PairClass>(kinds[i])});
    }
    return Done{};
}

Status get_vectors(ByteReader& in, std::size_t count, std::vector<Vec3>& vectors) {
    const auto values = in.get_array<double>(3 * count);
    if (in.failed()) {
        return bad("points cut short");
    }
    if (!std::all_of(values.begin(), values.end(), is_canonical)) {
        return bad("a number that is not in canonical form");
    }
    vectors.reserve(count);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
    }
    return Done{};
}

Status get_shared_points(ByteReader& in, ScenarioResult& result) {
    const auto counts = in.get_array<std::uint8_t>(result.pairs.size());
    if (in.failed()) {
        return bad("points cut short");
    }
    result.point_offsets.reserve(counts.size() + 1);
    std::uint32_t points = 0;
    result.point_offsets.push_back(points);
    for (const std::uint8_t count : counts) {
        if (count > points_of_pair_max) {
            return bad("too many points of a pair");
        }
        points += count;
        result.point_offsets.push_back(points);
    }
    if (const Status status = get_vectors(in, counts.size(), result.point_origins); !status) {
        return status;
    }
    return get_vectors(in, points, result.points);
}

/// Checks that level, class, pairs and distance bound of a result are consistent.
Status check_sense(const ScenarioResult& result) {
    const bool is_any = result.level == Level::Any;
    const bool in_contact =
        result.kind == ScenarioClass::Touch || result.kind == ScenarioClass::Cross;
    if (is_any ? in_contact : result.kind == ScenarioClass::Contact) {
        return bad("a class that its level does not know");
    }
    const bool may_count = in_contact || result.kind == ScenarioClass::Undecided;
    if ((result.pair_count > 0 && (is_any || !may_count)) ||
        (result.pair_count == 0 && in_contact) || result.pairs.size() > result.pair_count) {
        return bad("a number of pairs that does not fit the class");
    }
    if (result.pair_count > 0 && result.distance_bound > 0) {
        return bad("a distance between bodies in contact");
    }
    const bool is_proper = std::any_of(result.pairs.begin(), result.pairs.end(), [](const auto& p) {
        return p.kind == PairClass::Proper;
    });
    if (is_proper && result.kind == ScenarioClass::Touch) {
        return bad("a touch with a proper pair");
    }
    return Done{};
}

} // namespace

std::string_view to_text(ScenarioClass value) {
    const auto number = static_cast<std::size_t>(value);
    CD_CHECK(number < class_names.size());
    return class_names[number];
}

Bytes encode_result(const ScenarioResult& result) {
    ByteWriter out;
    put_body(out, result);
    return out.take();
}

void put_record(ByteWriter& out, const ScenarioResult& result) {
    const std::uint64_t bytes = bytes_of_record(result);
    CD_CHECK(bytes <= UINT32_MAX);
    out.put(static_cast<std::uint32_t>(bytes));
    const std::size_t begin = out.size();
    put_body(out, result);
    CD_CHECK(out.size() - begin == bytes);
}

Result<ScenarioResult> decode_result(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    ScenarioResult result;
    if (const Status status = get_head(in, result); !status) {
        return status.error();
    }
    if (result.kind == ScenarioClass::Failed) {
        result.failure = in.get_text();
    } else {
        if (result.level >= Level::Pairs) {
            if (const Status status = get_pairs(in, result); !status) {
                return status.error();
            }
        }
        if (result.level >= Level::Contacts) {
            if (const Status status = get_shared_points(in, result); !status) {
                return status.error();
            }
        }
    }
    if (!in.complete()) {
        return bad("cut short or bytes left over");
    }
    if (const Status status = check_sense(result); !status) {
        return status.error();
    }
    return result;
}

void fail_above_limit(ScenarioResult& result, std::uint64_t bytes_max) {
    // Upper bound on the size of a record's head and counts.
    constexpr std::uint64_t fixed_bytes = 64;
    const std::uint64_t bytes = fixed_bytes + pair_bytes * result.pairs.size() +
                                point_bytes * (result.point_origins.size() + result.points.size()) +
                                sizeof(std::uint32_t) * result.point_offsets.size();
    if (bytes <= bytes_max) {
        return;
    }
    ScenarioResult failed;
    failed.index = result.index;
    failed.body_a = result.body_a;
    failed.body_b = result.body_b;
    failed.level = result.level;
    failed.kind = ScenarioClass::Failed;
    failed.failure = std::to_string(result.pair_count) +
                     " pairs are too many for one result; set limit_pairs, or ask for level count";
    result = std::move(failed);
}

Sha256 digest_of(const ScenarioResult& result) {
    return sha256(encode_result(result));
}

} // namespace cd
