// Estimates the time and size of a run from scenarios sampled evenly over its job.
#pragma once

#include "client/job/prepared_job.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/pair/triangle_pair.hpp"

#include <chrono>
#include <cstdint>
#include <string>

namespace cd {

struct RunEstimate {
    std::uint64_t scenarios = 0; ///< Scenarios of the job.
    std::uint64_t sampled = 0;   ///< Scenarios that were run for the estimate.
    double seconds = 0;          ///< Expected run time, without preparation.
    double seconds_low = 0;      ///< Two standard errors below `seconds`.
    double seconds_high = 0;     ///< Two standard errors above `seconds`.
    double box_tests = 0;
    double triangle_tests = 0;
    std::uint64_t bytes = 0; ///< Size of the results folder; 0 without one.
};

struct EstimateOptions {
    std::uint64_t samples_max = 200;
    std::chrono::milliseconds time_max{5000}; ///< Time limit; reading samples takes at most half.
    PairStage first_stage = PairStage::Float;
    bool keeps_inputs = true; ///< The run copies meshes and poses to its folder.
};

/// Runs samples of a job, whose trees are built, on the pool's threads, and writes their results to
/// a temporary folder, which it removes. Reads and runs at least one sample, even past the time
/// limit. Errors: from reading poses and from writing files.
[[nodiscard]] Result<RunEstimate>
estimate_run(const PreparedJob& job, ThreadPool& pool, const EstimateOptions& options);

/// Returns "about 52 s here (731/s), 0.4 GB", or "about 40 to 75 s here ..." for a wide range.
[[nodiscard]] std::string estimate_text(const RunEstimate& estimate);
/// Returns a JSON object with the keys scenarios, sampled, seconds {low, expected, high},
/// scenarios_per_second, box_tests, triangle_tests, bytes, and refused: the error in `room`, which
/// `check_room` gave, or null.
[[nodiscard]] std::string estimate_json(const RunEstimate& estimate, const Status& room);

/// Refuses results larger than `bytes_max` or than half of the free space at the output folder.
/// Callers skip the check if the user gives --yes. Errors: BadInput with time, size and remedies.
[[nodiscard]] Status
check_room(const RunEstimate& estimate, const OutputSpec& output, std::uint64_t bytes_max);

} // namespace cd
