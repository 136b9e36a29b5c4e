// Estimates time and size of a run from scenarios sampled evenly over its job.
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
    double seconds = 0;          ///< On this machine's threads, without reading and building.
    double seconds_low = 0;      ///< Two standard errors of the mean below and above.
    double seconds_high = 0;
    double box_tests = 0;
    double triangle_tests = 0;
    std::uint64_t bytes = 0; ///< Size of the results folder; 0 without one.
};

struct EstimateOptions {
    std::uint64_t samples_max = 200;
    std::chrono::milliseconds time_max{5000}; ///< Half of it at most to read the samples.
    PairStage first_stage = PairStage::Float;
    bool keeps_inputs = true; ///< The results folder gets the meshes and poses.
};

/// Runs samples of a job with trees on the pool's threads, and writes what a run would keep of them
/// to a temporary folder that is removed. Where time is over, one sample is read and run all the
/// same. Errors: those of the poses and of the files.
[[nodiscard]] Result<RunEstimate>
estimate_run(const PreparedJob& job, ThreadPool& pool, const EstimateOptions& options);

/// "about 52 s here (731/s), 0.4 GB", or "about 40 to 75 s here ..." where samples differ much.
[[nodiscard]] std::string estimate_text(const RunEstimate& estimate);
/// An object with the keys scenarios, sampled, seconds {low, expected, high}, scenarios_per_second,
/// box_tests, triangle_tests, bytes, and refused: what `check_room` says, or null.
[[nodiscard]] std::string estimate_json(const RunEstimate& estimate, const Status& room);

/// More than `bytes_max`, or more than half of what is free where the folder is to be, wants a
/// user's word. Errors: BadInput with time, size and the ways out.
[[nodiscard]] Status
check_room(const RunEstimate& estimate, const OutputSpec& output, std::uint64_t bytes_max);

} // namespace cd
