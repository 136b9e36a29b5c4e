// Finished scenarios of a local run, as they are stored.
#pragma once

#include "client/local/done_scenario.hpp"
#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/result.hpp"
#include "common/search/contact_pair.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace cd {

/// The results of consecutive scenarios. The thread that runs them encodes and hashes them, so that
/// the thread that merges and writes them handles a few bytes of each.
class DoneBlock {
  public:
    [[nodiscard]] bool empty() const { return facts_.empty(); }
    [[nodiscard]] std::size_t size() const { return facts_.size(); }
    /// Returns the index of the first scenario. There is one.
    [[nodiscard]] std::uint64_t first() const { return first_; }
    /// Returns facts about each scenario, in order.
    [[nodiscard]] std::span<const ScenarioFacts> facts() const { return facts_; }
    /// Returns the SHA-256 of each record, in order.
    [[nodiscard]] std::span<const Sha256> digests() const { return digests_; }
    /// Returns the canonical records in order, each preceded by its length as u32.
    [[nodiscard]] std::span<const std::byte> records() const { return records_.bytes(); }
    /// Returns the approximate size in memory.
    [[nodiscard]] std::uint64_t bytes() const;

    /// Adds the scenario after the last one; any scenario to an empty block.
    void add(const ScenarioResult& result);
    /// Adds a scenario of a query with maps, with all its pairs.
    void add(const ScenarioResult& result, std::vector<ContactPair> found);

    /// Calls `take` with each result, decoded, in order. Errors: those of `take`.
    [[nodiscard]] Status for_each(const std::function<Status(const DoneScenario&)>& take) const;

  private:
    std::uint64_t first_ = 0;
    std::vector<ScenarioFacts> facts_;
    std::vector<Sha256> digests_;
    ByteWriter records_;
    std::vector<std::vector<ContactPair>> found_; ///< All pairs of each scenario, for maps.
    std::uint64_t found_bytes_ = 0;
};

/// Returns a block of one result.
[[nodiscard]] DoneBlock block_of(const DoneScenario& done);

} // namespace cd
