// What a report tells of a run's results: everything that one pass over the records finds.
#pragma once

#include "client/groups/body_choice.hpp"
#include "client/groups/group_sum.hpp"
#include "client/job/prepared_job.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/result/result.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

struct FailedScenario {
    std::uint64_t index = 0;
    std::string reason;
};

/// An overview of all results of a run. Memory: `GroupSum`, and 33 bytes a scenario,
/// with distances 41.
class RunOverview {
  public:
    static constexpr std::size_t worst_max = 10;
    static constexpr std::size_t nearest_max = 10;
    static constexpr std::size_t failures_max = 20;
    /// The class of a scenario without a result, in `classes`.
    static constexpr std::uint8_t no_result = 255;
    /// The class of a scenario that the report is not about, in `classes`.
    static constexpr std::uint8_t left_out = 254;

    /// Reads all records of a run with `scenarios` scenarios, and adds them to `groups`. `scene` is
    /// that of the run. Errors: Io; BadInput for a record that the run cannot have; Interrupted.
    [[nodiscard]] static Result<RunOverview>
    read(const RecordFile& records,
         GroupSum groups,
         std::uint64_t scenarios,
         const StopCheck& stop,
         const std::optional<SceneHead>& scene = std::nullopt);

    /// Leaves out the scenarios of other bodies, whose records were not read: they are not missing.
    /// Errors: from reading poses; Interrupted.
    [[nodiscard]] Status
    restrict_to(const BodyChoice& bodies, PoseSource& poses, const StopCheck& stop);

    /// Runs the worst scenarios again, as the page does, and gives them pairs and points. For
    /// runs below `level pairs`, whose records list none. `job` has trees. A scenario whose run
    /// fails or takes longer than `run_max` remains without pairs. Errors: from reading poses;
    /// Interrupted.
    [[nodiscard]] Status add_pairs_to_worst(const PreparedJob& job,
                                            std::chrono::milliseconds run_max,
                                            const StopCheck& stop);

    /// The names of the bodies that the overview is restricted to, with commas; else empty.
    [[nodiscard]] const std::string& bodies() const { return bodies_; }
    /// The counts of the scenarios that are not left out.
    [[nodiscard]] const Summary& summary() const { return summary_; }
    /// The run's digest; nothing while results are missing, or if scenarios are left out.
    [[nodiscard]] const std::optional<Sha256>& digest() const { return digest_; }
    /// The class of each scenario, as `ScenarioClass`, `no_result` or `left_out`.
    [[nodiscard]] const std::vector<std::uint8_t>& classes() const { return classes_; }
    /// The worst scenarios in contact or near (`Badness`), the worst first, and among equal ones
    /// the first. Their pairs are those of the records, or of `add_pairs_to_worst`.
    [[nodiscard]] const std::vector<ScenarioResult>& worst() const { return worst_; }
    /// The scenarios of least distance, the nearest first, and among equal ones the first. Each
    /// lists its nearest pair (`list_witness`).
    [[nodiscard]] const std::vector<ScenarioResult>& nearest() const { return nearest_; }
    /// All distances, in the order of the records.
    [[nodiscard]] const std::vector<double>& distances() const { return distances_; }
    /// The scenarios that a report has pictures of: the worst, then those of least distance.
    [[nodiscard]] std::vector<ScenarioResult> pictured() const;
    [[nodiscard]] const std::vector<FailedScenario>& failures() const { return failures_; }
    [[nodiscard]] GroupSum& groups() { return groups_; }
    [[nodiscard]] const GroupSum& groups() const { return groups_; }

  private:
    RunOverview(GroupSum groups, std::uint64_t scenarios);

    void add(const ScenarioResult& result);
    void add_to_worst(const ScenarioResult& result);
    void add_distance(const ScenarioResult& result);

    GroupSum groups_;
    std::string bodies_;
    Summary summary_;
    std::optional<Sha256> digest_;
    std::vector<std::uint8_t> classes_;
    std::vector<ScenarioResult> worst_;
    std::vector<ScenarioResult> nearest_;
    std::vector<double> distances_;
    std::vector<FailedScenario> failures_;
};

} // namespace cd
