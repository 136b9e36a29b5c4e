// Results that the journal commits together: where their records stand, whose they are, and what
// became known of results that were there before; and which scenarios were lost instead.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/result/merge.hpp"
#include "master/base/worker_process.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// One result, of which the record stands in the job's segment.
struct ResultRow {
    std::uint64_t scenario = 0;
    std::uint64_t length = 0; ///< Of the record.
    ScenarioFacts facts;
    Sha256 digest;

    friend bool operator==(const ResultRow&, const ResultRow&) = default;
};

/// So many rows, one after the other, have one author.
struct AuthorRun {
    std::uint64_t rows = 0;
    WorkerProcess author = 0;

    friend bool operator==(const AuthorRun&, const AuthorRun&) = default;
};

/// What became known of a result after it was written.
struct Remark {
    enum class Kind : std::uint8_t {
        Disputed, ///< Another result differs from it, and the master has to compute it itself.
        Settled,  ///< It has: of that dispute nothing is left, and no author's word counts.
        Vouched,  ///< Another worker has answered alike: its author's word is not all there is.
    };
    Kind kind = Kind::Vouched;
    std::uint64_t scenario = 0;
    // Of a dispute: the other result, and whose that is.
    Sha256 digest;
    WorkerProcess author = 0;

    friend bool operator==(const Remark&, const Remark&) = default;
};

/// Results that were committed together; their records follow each other in the segment.
struct ResultGroup {
    std::uint64_t begin = 0; ///< The segment's end before them.
    std::vector<ResultRow> rows;
    std::vector<Bytes> maps;        ///< `pack_map`; together they are the map of these results.
    std::vector<AuthorRun> authors; ///< Of all rows.
    std::vector<Remark> remarks;    ///< In their order. On rows of this group, or before it.
    std::vector<LostPlaces> losses; ///< In their order. Some have a result by now.
};

/// Writes each process once (8 bytes); a run of rows takes 2 bytes or a few more. The runs cover
/// all rows.
[[nodiscard]] Bytes encode_group(const ResultGroup& group);
/// Errors: BadFrame for damaged bytes.
[[nodiscard]] Result<ResultGroup> decode_group(std::span<const std::byte> bytes);

} // namespace cd
