// What the page needs of all records of a run at once: classes, counts, sums and the contact map.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "common/job/result/contact_map.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/record_file.hpp"
#include "web/server/page_request.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cd {

/// Memory: five bytes a scenario, with distances thirteen. Scenarios without a record have the
/// class `no_class` and count 0.
class RecordIndex {
  public:
    /// Reads all records of a run of `scenarios` scenarios. Errors: TooLarge over
    /// `limits::page_index_scenarios_max`; Io naming the file; Interrupted.
    [[nodiscard]] static Result<RecordIndex> read(const RecordFile& records,
                                                  std::uint64_t scenarios,
                                                  ThreadPool& pool,
                                                  const StopCheck& stop = {});

    [[nodiscard]] std::uint8_t class_of(std::uint64_t scenario) const { return classes_[scenario]; }
    /// Returns a scenario's number of pairs (`pairs_of_class`), at most 2^32 - 1.
    [[nodiscard]] std::uint32_t count_of(std::uint64_t scenario) const { return counts_[scenario]; }
    /// Returns a scenario's distance; NaN without one.
    [[nodiscard]] double distance_of(std::uint64_t scenario) const;
    [[nodiscard]] const Summary& summary() const { return summary_; }
    /// The map of all listed pairs; empty below `level pairs`.
    [[nodiscard]] const ContactMap& map() const { return map_; }

    /// Returns at most `count` scenarios in contact or near: the worst ones (`Badness`), the worst
    /// first; of equal ones the first. After them, those of least distance, the nearest first.
    [[nodiscard]] std::vector<std::uint64_t> worst(std::size_t count) const;
    /// Returns the nearest scenario after `wanted.from`, or before it, that has a wanted class and
    /// that `fits`; nothing if there is none.
    [[nodiscard]] std::optional<std::uint64_t>
    next(const NextContact& wanted, const std::function<bool(std::uint64_t)>& fits) const;

  private:
    void add(const ScenarioResult& result);
    void add_nearest(std::size_t count, std::vector<std::uint64_t>& worst) const;

    std::vector<std::uint8_t> classes_;
    std::vector<std::uint32_t> counts_;
    std::vector<double> distances_; ///< Empty if no record has a distance.
    Summary summary_;
    ContactMap map_;
};

} // namespace cd
