#include "common/job/result/result.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/job/result/canonical_numbers.hpp"
#include "common/job/result/result_sense.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace cd {

namespace {

constexpr std::uint8_t version_contacts = 2;
constexpr std::uint8_t version = 3;
constexpr std::uint8_t flag_clearance = 1;
constexpr std::uint8_t flag_surfaces_only = 1;
constexpr std::uint8_t flag_insides_skipped = 2;
constexpr std::uint8_t flag_scene = 4;
constexpr std::size_t head_bytes = 28;
/// What version 3 adds to the head: the question and the step.
constexpr std::size_t question_bytes = 1 + sizeof(std::uint64_t);
/// Places of the index and of the flags in version 3.
constexpr std::size_t index_offset = 2;
constexpr std::size_t flags_offset = 20;
constexpr std::size_t near_count_bytes = sizeof(std::uint64_t);
constexpr std::uint64_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;
constexpr std::uint64_t point_bytes = 3 * sizeof(double);
/// The intersection of two triangles is at most a hexagon.
constexpr std::uint32_t points_of_pair_max = 6;

constexpr std::uint32_t points_of_near_pair = 2;

constexpr std::array<std::string_view, 8> class_names{
    "separate", "touch", "cross", "inside", "contact", "undecided", "failed", "near"};

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

std::uint8_t version_of(const ScenarioResult& result) {
    const bool is_plain =
        !result.has_clearance && result.question == Question::Contacts && !result.step;
    return is_plain ? version_contacts : version;
}

/// Whether results of this question may have a clearance.
bool may_have_clearance(Question question) {
    return question == Question::Contacts || question == Question::Motion;
}

/// Whether the head has the byte of more flags, which tells a clearance.
bool has_more_flags(const ScenarioResult& result) {
    return version_of(result) == version && may_have_clearance(result.question);
}

std::size_t bytes_of_head(const ScenarioResult& result) {
    return head_bytes + (version_of(result) == version ? question_bytes : 0) +
           (has_more_flags(result) ? 1 : 0) + (result.has_clearance ? near_count_bytes : 0);
}

/// Returns the exact number of bytes of a record.
std::uint64_t bytes_of_record(const ScenarioResult& result) {
    const std::uint64_t head =
        bytes_of_head(result) + (result.kind == ScenarioClass::Undecided ? sizeof(double) : 0);
    if (result.kind == ScenarioClass::Failed) {
        return head + sizeof(std::uint32_t) + result.failure.size();
    }
    if (result.question == Question::Distance) {
        return head + bytes_of_witness(result.nearest);
    }
    const std::uint64_t motion = result.motion ? bytes_of_motion(*result.motion) : 0;
    if (result.level < Level::Pairs) {
        return head + motion;
    }
    const std::uint64_t pairs = sizeof(std::uint32_t) + pair_bytes * result.pairs.size();
    const std::uint64_t points =
        result.level < Level::Contacts
            ? 0
            : result.pairs.size() + point_bytes * (result.pairs.size() + result.points.size()) +
                  sizeof(double) * result.near_distances.size();
    return head + pairs + points + hit_bytes * result.hits.size() + motion;
}

Error bad(const char* what) {
    return {ErrorCode::BadFrame, std::string("result record: ") + what};
}

/// Writes the head of a record in one piece, for speed: at `level count` the head is the whole
/// record, and the master writes a million records per second.
void put_head(ByteWriter& out, const ScenarioResult& result) {
    std::array<std::uint8_t, head_bytes + question_bytes + 1 + near_count_bytes> head;
    std::uint8_t* to = head.data();
    const auto put = [&](auto value) {
        std::memcpy(to, &value, sizeof value);
        to += sizeof value;
    };
    put(version_of(result));
    if (version_of(result) == version) {
        put(static_cast<std::uint8_t>(result.question));
    }
    put(result.index);
    put(result.body_a);
    put(result.body_b);
    put(static_cast<std::uint8_t>(result.level));
    put(static_cast<std::uint8_t>(result.kind));
    put(static_cast<std::uint8_t>((result.surfaces_only ? flag_surfaces_only : 0) |
                                  (result.insides_skipped ? flag_insides_skipped : 0) |
                                  (result.step ? flag_scene : 0)));
    put(result.pair_count);
    if (version_of(result) == version) {
        put(result.step.value_or(0));
    }
    if (has_more_flags(result)) {
        put(static_cast<std::uint8_t>(result.has_clearance ? flag_clearance : 0));
    }
    if (result.has_clearance) {
        put(result.near_count);
    }
    const auto bytes = static_cast<std::size_t>(to - head.data());
    CD_CHECK(bytes == bytes_of_head(result));
    out.put_array(std::span<const std::uint8_t>(head).first(bytes));
}

/// Empties a result, and keeps the memory of its lists.
void clear(ScenarioResult& result) {
    static_cast<ScenarioHead&>(result) = {};
    result.pair_count = 0;
    result.distance_bound = 0;
    result.near_count = 0;
    result.pairs.clear();
    result.point_origins.clear();
    result.point_offsets.clear();
    result.points.clear();
    result.near_distances.clear();
    result.nearest.reset();
    result.hits.clear();
    result.motion.reset();
    result.failure.clear();
}

/// Reads what version 3 adds behind the head of contacts and motions. Contacts have that version
/// only in a scene or with a clearance.
Status get_more_flags(ByteReader& in, ScenarioResult& result) {
    const auto flags = in.get<std::uint8_t>();
    result.has_clearance = flags == flag_clearance;
    result.near_count = result.has_clearance ? in.get<std::uint64_t>() : 0;
    if (in.failed()) {
        return bad("cut short");
    }
    if (flags > flag_clearance) {
        return bad("unknown flag");
    }
    const bool is_needed =
        result.has_clearance || result.step || result.question != Question::Contacts;
    return is_needed ? Status(Done{}) : bad("version 3 without need");
}

/// Reads version and question. Returns the version.
Result<std::uint8_t> get_question(ByteReader& in, ScenarioResult& result) {
    const auto from_version = in.get<std::uint8_t>();
    if (from_version == version_contacts) {
        return from_version;
    }
    const auto question = in.get<std::uint8_t>();
    result.question = static_cast<Question>(question);
    if (from_version != version || result.question > Question::Shots) {
        return bad("unknown version or question");
    }
    return from_version;
}

/// Reads the step, which is 0 unless the result is of a scene.
Status get_step(ByteReader& in, bool is_of_scene, ScenarioResult& result) {
    const auto step = in.get<std::uint64_t>();
    if (is_of_scene) {
        result.step = step;
    }
    return is_of_scene || step == 0 ? Status(Done{}) : bad("a step outside a scene");
}

Status get_head(ByteReader& in, ScenarioResult& result) {
    const std::uint8_t from_version = CD_TRY(get_question(in, result));
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
    const std::uint8_t states = flags & ~flag_scene;
    const bool is_of_scene = (flags & flag_scene) != 0;
    if (level > static_cast<std::uint8_t>(Level::Contacts) || kind >= class_names.size() ||
        states > flag_insides_skipped || (is_of_scene && from_version != version)) {
        return bad("unknown level, class or flag");
    }
    result.level = static_cast<Level>(level);
    result.kind = static_cast<ScenarioClass>(kind);
    result.surfaces_only = (flags & flag_surfaces_only) != 0;
    result.insides_skipped = (flags & flag_insides_skipped) != 0;
    if (from_version == version) {
        CD_TRY(get_step(in, is_of_scene, result));
        if (may_have_clearance(result.question)) {
            CD_TRY(get_more_flags(in, result));
        }
    }
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
    const std::uint64_t triangles_bytes = std::uint64_t{count} * sizeof(std::uint32_t);
    const auto a = in.get_bytes(triangles_bytes);
    const auto b = in.get_bytes(triangles_bytes);
    const auto kinds = in.get_bytes(count);
    if (in.failed()) {
        return bad("pairs cut short");
    }
    const PairClass last_kind = result.has_clearance                 ? PairClass::Near
                                : result.question == Question::Shots ? PairClass::Touch
                                                                     : PairClass::Proper;
    // Errors are reported after the loop, which keeps branches out of it.
    result.pairs.resize(count);
    bool are_known = true;
    bool ascend = true;
    std::uint64_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
        ContactPair& pair = result.pairs[i];
        std::memcpy(&pair.a, a.data() + i * sizeof pair.a, sizeof pair.a);
        std::memcpy(&pair.b, b.data() + i * sizeof pair.b, sizeof pair.b);
        pair.kind = static_cast<PairClass>(kinds[i]);
        are_known = are_known && pair.kind >= PairClass::Touch && pair.kind <= last_kind;
        const std::uint64_t both = std::uint64_t{pair.a} << 32 | pair.b;
        ascend = ascend && (i == 0 || before < both);
        before = both;
    }
    if (!are_known) {
        return bad("unknown class of a pair");
    }
    return ascend ? Status(Done{}) : bad("pairs are not strictly ascending");
}

Status get_shared_points(ByteReader& in, ScenarioResult& result) {
    const auto counts = in.get_array<std::uint8_t>(result.pairs.size());
    if (in.failed()) {
        return bad("points cut short");
    }
    result.point_offsets.reserve(counts.size() + 1);
    std::uint32_t points = 0;
    result.point_offsets.push_back(points);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const bool is_near = result.pairs[i].kind == PairClass::Near;
        if (is_near ? counts[i] != points_of_near_pair : counts[i] > points_of_pair_max) {
            return bad("a number of points that its pair cannot have");
        }
        points += counts[i];
        result.point_offsets.push_back(points);
    }
    if (const Status status = get_points(in, counts.size(), result.point_origins); !status) {
        return status;
    }
    return get_points(in, points, result.points);
}

Status get_near_distances(ByteReader& in, ScenarioResult& result) {
    const std::vector<double> distances = in.get_array<double>(listed_near_pairs(result));
    if (in.failed()) {
        return bad("distances cut short");
    }
    for (const double distance : distances) {
        if (!is_distance(distance)) {
            return bad("a distance that is none");
        }
    }
    result.near_distances.assign(distances.begin(), distances.end());
    return Done{};
}

/// Reads what follows the head.
Status get_body(ByteReader& in, ScenarioResult& result) {
    if (result.kind == ScenarioClass::Failed) {
        result.failure = in.get_text();
        return Done{};
    }
    if (result.question == Question::Distance) {
        return get_witness(in, result.nearest);
    }
    if (result.level >= Level::Pairs) {
        CD_TRY(get_pairs(in, result));
    }
    if (result.question == Question::Shots) {
        return get_hits(in, result.pairs.size(), result.hits);
    }
    if (result.question == Question::Motion) {
        return get_motion(in, result.motion.emplace());
    }
    if (result.level >= Level::Contacts) {
        CD_TRY(get_shared_points(in, result));
        CD_TRY(get_near_distances(in, result));
    }
    return Done{};
}

bool is_of_scene(std::span<const std::byte> record) {
    return record.size() > flags_offset && std::to_integer<std::uint8_t>(record[0]) == version &&
           (std::to_integer<std::uint8_t>(record[flags_offset]) & flag_scene) != 0;
}

} // namespace

std::string_view to_text(ScenarioClass value) {
    const auto number = static_cast<std::size_t>(value);
    CD_CHECK(number < class_names.size());
    return class_names[number];
}

void put_result(ByteWriter& out, const ScenarioResult& result) {
    put_head(out, result);
    if (result.kind == ScenarioClass::Undecided) {
        out.put(canonical(result.distance_bound));
    }
    if (result.kind == ScenarioClass::Failed) {
        out.put_text(result.failure);
        return;
    }
    if (result.question == Question::Distance) {
        put_witness(out, result.nearest);
        return;
    }
    if (result.level >= Level::Pairs) {
        CD_CHECK(result.pairs.size() <= UINT32_MAX);
        out.put(static_cast<std::uint32_t>(result.pairs.size()));
        put_pairs(out, result.pairs);
    }
    if (result.question == Question::Shots) {
        CD_CHECK(result.hits.size() == result.pairs.size());
        put_hits(out, result.hits);
        return;
    }
    if (result.question == Question::Motion) {
        put_motion(out, result.motion.value());
        return;
    }
    if (result.level >= Level::Contacts) {
        put_shared_points(out, result);
        put_numbers(out, result.near_distances);
    }
}

void put_settled(ByteWriter& out, const ScenarioResult& result, std::span<const std::byte> record) {
    put_head(out, result);
    put_bytes(out, record.subspan(bytes_of_head(result)));
}

Bytes encode_result(const ScenarioResult& result) {
    ByteWriter out;
    put_result(out, result);
    return out.take();
}

void put_record(ByteWriter& out, const ScenarioResult& result) {
    const std::uint64_t bytes = bytes_of_record(result);
    CD_CHECK(bytes <= UINT32_MAX);
    out.put(static_cast<std::uint32_t>(bytes));
    const std::size_t begin = out.size();
    put_result(out, result);
    CD_CHECK(out.size() - begin == bytes);
}

Result<ScenarioResult> decode_result(std::span<const std::byte> bytes) {
    ScenarioResult result;
    CD_TRY(decode_result(bytes, result));
    return result;
}

Status decode_result(std::span<const std::byte> bytes, ScenarioResult& result) {
    clear(result);
    ByteReader in(bytes);
    CD_TRY(get_head(in, result));
    CD_TRY(get_body(in, result));
    if (!in.complete()) {
        return bad("cut short or bytes left over");
    }
    return check_sense(result);
}

void fail_above_limit(ScenarioResult& result, std::uint64_t bytes_max) {
    // Upper bound on the size of a record's head and counts.
    constexpr std::uint64_t fixed_bytes = 64;
    const std::uint64_t bytes = fixed_bytes + pair_bytes * result.pairs.size() +
                                point_bytes * (result.point_origins.size() + result.points.size()) +
                                sizeof(double) * result.near_distances.size() +
                                hit_bytes * result.hits.size() +
                                (result.motion ? bytes_of_motion(*result.motion) : 0) +
                                sizeof(std::uint32_t) * result.point_offsets.size();
    if (bytes <= bytes_max) {
        return;
    }
    ScenarioResult failed;
    failed.index = result.index;
    failed.body_a = result.body_a;
    failed.body_b = result.body_b;
    failed.level = result.level;
    failed.has_clearance = result.has_clearance;
    failed.question = result.question;
    failed.step = result.step;
    failed.kind = ScenarioClass::Failed;
    failed.failure = std::to_string(result.pair_count + result.near_count) +
                     " pairs are too many for one result; set limit_pairs, or ask for level count";
    result = std::move(failed);
}

std::optional<std::size_t> bytes_before_pairs(std::span<const std::byte> record) {
    ByteReader in(record);
    ScenarioResult result;
    if (!get_head(in, result) || result.level < Level::Pairs ||
        result.kind == ScenarioClass::Failed) {
        return std::nullopt;
    }
    const auto pairs = in.get<std::uint32_t>();
    if (in.failed() || pairs == 0 || pairs > in.remaining() / pair_bytes) {
        return std::nullopt;
    }
    return record.size() - in.remaining();
}

Sha256 digest_of_record(std::span<const std::byte> record) {
    // Records of scenes are longer, so no short record needs another index.
    static_assert(head_bytes + question_bytes > unhashed_record_bytes_max);
    if (record.size() <= unhashed_record_bytes_max) {
        Sha256 digest;
        std::ranges::copy(record, digest.bytes.begin());
        digest.bytes.back() = static_cast<std::byte>(record.size());
        return digest;
    }
    if (!is_of_scene(record)) {
        return sha256(record);
    }
    constexpr std::array<std::byte, sizeof(std::uint64_t)> index_of_all{};
    Sha256Stream stream;
    stream.update(record.first(index_offset));
    stream.update(index_of_all);
    stream.update(record.subspan(index_offset + index_of_all.size()));
    return stream.finish();
}

Sha256 digest_of(const ScenarioResult& result) {
    return digest_of_record(encode_result(result));
}

} // namespace cd
