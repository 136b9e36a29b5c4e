// The result of one scenario, and its canonical record, which is digested, sent and stored.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/geometry/types.hpp"
#include "common/job/query.hpp"
#include "common/job/result/nearest_witness.hpp"
#include "common/job/result/pair_hit.hpp"
#include "common/motion/outcome_bytes.hpp"
#include "common/search/contact_pair.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// The class of a scenario (docs/formats.md). `level any` reports Contact for Touch and Cross, and
/// Question::Shots for any hit. Of a motion it is the class at the instant of the event; without
/// one, Undecided, or if the bodies are free throughout, their class at the motion's begin.
enum class ScenarioClass : std::uint8_t {
    Separate = 0,
    Touch = 1,
    Cross = 2,
    Inside = 3,
    Contact = 4,
    Undecided = 5, ///< Of a motion: open parts, and no instant with the event. Of contacts only in
                   ///< files of earlier versions, under a tolerance: some boxes were not tested.
    Failed = 6,
    Near = 7, ///< No contact, but a pair of triangles is at most the query's clearance apart.
};

[[nodiscard]] std::string_view to_text(ScenarioClass value);

/// True for the classes in which the bodies share a point.
[[nodiscard]] constexpr bool is_contact(ScenarioClass kind) {
    return kind == ScenarioClass::Touch || kind == ScenarioClass::Cross ||
           kind == ScenarioClass::Inside || kind == ScenarioClass::Contact;
}

/// What a result says before its numbers and lists.
struct ScenarioHead {
    std::uint64_t index = 0;
    std::uint32_t body_a = 0;
    std::uint32_t body_b = 1;
    Question question = Question::Contacts;
    Level level = Level::Pairs;
    ScenarioClass kind = ScenarioClass::Separate;
    bool surfaces_only = false;   ///< A body is open, so containment is not decided.
    bool insides_skipped = false; ///< Ignored pairs leave parts whose containment is not decided.
    bool has_clearance = false;   ///< The query has a clearance, so near pairs are in the result.
    /// In a scene of many bodies, the number of the step; nothing in other jobs.
    std::optional<std::uint64_t> step = {};
};

struct ScenarioResult : ScenarioHead {
    /// Number of all pairs in contact, even if `pairs` is cut off; 0 at `level any`. If contacts
    /// are Undecided, the number of proven pairs, which need not be all.
    std::uint64_t pair_count = 0;
    /// For class Undecided, an upper bound on the distance of the two bodies in the world, in the
    /// job's unit; of a motion, on their distance at some time of every open part, or infinity if
    /// the search ended early. 0 if a contact is proven, and for other classes.
    double distance_bound = 0;
    /// Number of all pairs of class Near, even if `pairs` is cut off; 0 at `level any`.
    std::uint64_t near_count = 0;
    /// Pairs in contact and near pairs, sorted; only the first `limit_pairs` if limited.
    std::vector<ContactPair> pairs;

    /// At `level contacts`, for each pair in `pairs` the origin of its shared points, in the world.
    std::vector<Vec3> point_origins;
    /// At `level contacts`, `pairs.size() + 1` offsets: pair i has points [offset i, offset i + 1).
    std::vector<std::uint32_t> point_offsets;
    /// Points relative to the origin of their pair: shared points, or of a near pair the nearest
    /// point of A and that of B.
    std::vector<Vec3> points;
    /// At `level contacts`, for each near pair in `pairs` the distance of its triangles in the
    /// world, correctly rounded.
    std::vector<double> near_distances;

    /// With Question::Distance, unless the bodies touch or are farther apart than the query's
    /// `up_to`.
    std::optional<NearestWitness> nearest;
    /// With Question::Shots, for each pair in `pairs` its hit.
    std::vector<PairHit> hits;
    /// With Question::Motion, unless the scenario failed. `pairs` are those at its event.
    std::optional<MotionOutcome> motion;

    std::string failure; ///< Reason for class Failed, which has no pairs.

    [[nodiscard]] bool is_cut() const {
        return level >= Level::Pairs && pairs.size() < pair_count + near_count;
    }
};

/// Encodes the canonical record, little-endian. Statistics, times and hosts are never part of it.
///
///     u8 version: 3 in a scene, with a clearance or another question than contacts; else 2
///     version 3:        u8 question
///     u64 index    u32 body_a    u32 body_b    u8 level    u8 class
///     u8 flags (bit 0: surfaces only, bit 1: insides skipped; never both; bit 2: of a scene)
///       u64 pair_count
///     version 3:        u64 step; 0 unless of a scene
///     version 3, questions contacts and motion: u8 more flags (bit 0: clearance)
///     with a clearance: u64 near_count
///     class undecided:  f64 distance_bound
///     class failed:     u32 length, characters of the reason; the record ends here
///     level >= pairs:   u32 n; n x u32 triangles of A; n x u32 triangles of B; n x u8 class
///     level contacts:   n x u8 points of the pair (at most 6; a near pair has 2); n x 3 f64
///     origins;
///                       points x 3 f64; version 3: f64 distance of each near pair
///     question shots:   at level pairs: n f64 depths; n u8 flags; n u8 ranks
///     question motion:  the bytes of `put_motion`
///     question distance, whose level is any: u8 1 if there is a distance, else 0; if 1: f64
///                       distance; u32 triangle of A; u32 triangle of B; u8 feature; 3 f64 origin;
///                       3 f64 point of A; 3 f64 point of B
///
/// -0 is stored as 0, and a NaN (a point that left the range of double) as the one quiet NaN.
/// The caller guarantees the rules that `decode_result` checks.
[[nodiscard]] Bytes encode_result(const ScenarioResult& result);
/// Appends the canonical record to `out`.
void put_result(ByteWriter& out, const ScenarioResult& result);
/// Appends the canonical record of a result that differs from the result of `record` only in what
/// `Settler::settle` changes. Copies the bytes after the head, so it is faster than `put_result`.
void put_settled(ByteWriter& out, const ScenarioResult& result, std::span<const std::byte> record);
/// Appends the canonical record to `out`, after its length as u32.
void put_record(ByteWriter& out, const ScenarioResult& result);

/// Decodes a record. Encoding the result gives equal bytes again. The bytes are untrusted:
/// everything is checked (classes and levels in range and consistent, pairs strictly ascending,
/// counts that fit, numbers in canonical form). Errors: BadFrame.
[[nodiscard]] Result<ScenarioResult> decode_result(std::span<const std::byte> bytes);
/// Decodes a record into `result`. Overwrites its content and reuses its memory. After an error the
/// content is meaningless.
[[nodiscard]] Status decode_result(std::span<const std::byte> bytes, ScenarioResult& result);

/// Returns the number of bytes before the pairs of a record, or nothing if it has no pairs. The
/// last four of these bytes are the number of pairs. The bytes are untrusted.
[[nodiscard]] std::optional<std::size_t> bytes_before_pairs(std::span<const std::byte> record);

/// Replaces the result by a failed one with that reason if its record could exceed `bytes_max`
/// bytes. All code that runs a scenario calls this, so that one process and a cluster give equal
/// answers.
void fail_above_limit(ScenarioResult& result, std::uint64_t bytes_max);

/// A record of at most this many bytes is not hashed: it is its own digest.
inline constexpr std::size_t unhashed_record_bytes_max = sizeof(Sha256) - 1;
/// Returns the digest of a canonical record. That of a short record is the record itself, padded
/// with zeros, and its length in the last byte. That of a longer record is its SHA-256. A record of
/// a scene is hashed with index 0, so that its digest does not depend on which other pairs of
/// bodies have scenarios.
[[nodiscard]] Sha256 digest_of_record(std::span<const std::byte> record);
/// Returns the digest of the result's canonical record.
[[nodiscard]] Sha256 digest_of(const ScenarioResult& result);

} // namespace cd
