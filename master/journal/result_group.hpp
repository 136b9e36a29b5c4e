// A group of results that are committed together, with their authors, remarks on results, and
// losses of scenarios.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "master/base/instance_id.hpp"
#include "master/base/result_batch.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// A number of consecutive rows with one author.
struct AuthorRun {
    std::uint64_t rows = 0;
    InstanceId author = 0;

    friend bool operator==(const AuthorRun&, const AuthorRun&) = default;
};

/// A finding about results that were written earlier.
struct Remark {
    enum class Kind : std::uint8_t {
        Disputed,  ///< A later result of `scenario` differs; the master must run the scenario.
        Settled,   ///< The master has run `scenario`, so the dispute is decided.
        Withdrawn, ///< All results of `author` in this and earlier groups are dropped.
    };
    Kind kind = Kind::Withdrawn;
    std::uint64_t scenario = 0;
    Sha256 digest;         ///< Digest of the later result in a dispute.
    InstanceId author = 0; ///< Author of the later result, or of the withdrawn results.

    friend bool operator==(const Remark&, const Remark&) = default;
};

/// Results committed together; their records are contiguous in the segment.
struct ResultGroup {
    std::uint64_t begin = 0; ///< End of the segment before this group.
    std::vector<ResultRow> rows;
    std::vector<Bytes> maps;        ///< Packed contact maps, whose sum is the map of these results.
    std::vector<AuthorRun> authors; ///< The authors of all rows.
    std::vector<Remark> remarks;    ///< About rows of this group or earlier groups, in time order.
    std::vector<LostPositions> losses; ///< In time order. Some of the scenarios may have a result.
};

/// Encodes a group. A row takes 2 or 3 bytes where scenarios are consecutive, and lengths and
/// classes repeat. Each distinct author takes 8 bytes, and each run of rows about 2. The runs must
/// cover all rows.
[[nodiscard]] Bytes encode_group(const ResultGroup& group);
/// Errors: BadFrame for damaged bytes.
[[nodiscard]] Result<ResultGroup> decode_group(std::span<const std::byte> bytes);

} // namespace cd
