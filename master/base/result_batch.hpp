// Results in one block of memory, from the check of a message until they are in the job's segment.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/job/result/merge.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// One result without its record.
struct ResultRow {
    std::uint64_t scenario = 0;
    std::uint64_t length = 0; ///< Length of the record, bytes.
    ScenarioFacts facts;

    friend bool operator==(const ResultRow&, const ResultRow&) = default;
};

/// Size of the footer after each record in a segment. The footer is the record's XXH3 plus the
/// scenario's index, as u64, so it also detects the record of another scenario.
inline constexpr std::uint64_t record_footer_bytes = sizeof(std::uint64_t);
[[nodiscard]] std::uint64_t record_footer(std::uint64_t scenario,
                                          std::span<const std::byte> record);

/// Rows, digests and records of results.
class ResultBatch {
  public:
    /// Reserves memory for this many results, and for their records of so many bytes in all.
    void reserve(std::size_t results, std::size_t record_bytes);
    /// Adds a result, and encodes its record.
    void add(const ScenarioResult& result);
    /// Adds a result that was settled after it came with this canonical record (`put_settled`).
    void add_settled(const ScenarioResult& result, std::span<const std::byte> record);
    /// Adds a result by its canonical record.
    void add(std::uint64_t scenario, const ScenarioFacts& facts, std::span<const std::byte> record);
    /// Returns the batch without the results at these places, which ascend.
    [[nodiscard]] ResultBatch without(std::span<const std::size_t> places) const;

    [[nodiscard]] bool is_empty() const { return rows_.empty(); }
    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    [[nodiscard]] std::span<const ResultRow> rows() const { return rows_; }
    /// Returns the digest of each row's record (`digest_of_record`).
    [[nodiscard]] std::vector<Sha256> digests() const;
    /// The records as a segment stores them, each with its footer.
    [[nodiscard]] const Bytes& stored() const { return stored_.bytes(); }
    /// Bytes of all records, without footers.
    [[nodiscard]] std::uint64_t record_bytes() const {
        return stored_.size() - rows_.size() * record_footer_bytes;
    }

    /// Calls `take(row, record)` for each result.
    template <class Take>
    void for_each(const Take& take) const {
        std::span<const std::byte> rest(stored());
        for (const ResultRow& row : rows_) {
            take(row, rest.first(row.length));
            rest = rest.subspan(row.length + record_footer_bytes);
        }
    }

  private:
    /// Adds the row, the hash if needed, and the footer of the record at `begin` of `stored_`.
    void finish(std::uint64_t scenario, const ScenarioFacts& facts, std::size_t begin);

    std::vector<ResultRow> rows_;
    std::vector<Sha256> hashes_; ///< Digests of the records that must be hashed.
    ByteWriter stored_;
};

} // namespace cd
