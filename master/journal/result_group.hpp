// Results committed together: positions of their records, their authors, remarks on earlier
// results, and lost scenarios.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/result/merge.hpp"
#include "master/base/instance_id.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// One result, whose record is in the job's segment.
struct ResultRow {
    std::uint64_t scenario = 0;
    std::uint64_t length = 0; ///< Length of the record, bytes.
    ScenarioFacts facts;
    Sha256 digest;

    friend bool operator==(const ResultRow&, const ResultRow&) = default;
};

/// A number of consecutive rows with one author.
struct AuthorRun {
    std::uint64_t rows = 0;
    InstanceId author = 0;

    friend bool operator==(const AuthorRun&, const AuthorRun&) = default;
};

/// A finding about results after they were written.
struct Remark {
    enum class Kind : std::uint8_t {
        Disputed,  ///< Another result of `scenario` differs; the master must recompute it.
        Settled,   ///< The master has recomputed `scenario`.
        Withdrawn, ///< All results of `author` so far count as never having come.
    };
    Kind kind = Kind::Withdrawn;
    std::uint64_t scenario = 0;
    Sha256 digest;         ///< Digest of the other result in a dispute.
    InstanceId author = 0; ///< Author of the other result, or of the withdrawn ones.

    friend bool operator==(const Remark&, const Remark&) = default;
};

/// Results committed together; their records are contiguous in the segment.
struct ResultGroup {
    std::uint64_t begin = 0; ///< End of the segment before this group.
    std::vector<ResultRow> rows;
    std::vector<Bytes> maps;        ///< `pack_map`; together they form the map of these results.
    std::vector<AuthorRun> authors; ///< Authors of all rows.
    std::vector<Remark> remarks; ///< In order. They refer to rows of this group or of earlier ones.
    std::vector<LostPlaces> losses; ///< In order. Some of these scenarios may have a result by now.
};

/// Writes each process once (8 bytes); a run of rows takes 2 bytes or slightly more. The runs cover
/// all rows.
[[nodiscard]] Bytes encode_group(const ResultGroup& group);
/// Errors: BadFrame for damaged bytes.
[[nodiscard]] Result<ResultGroup> decode_group(std::span<const std::byte> bytes);

} // namespace cd
