// Measures what a job costs, by the code that the master and the worker run.
#pragma once

#include "bench/cluster/trace/trace.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

struct RecordOptions {
    std::string name;
    std::vector<std::uint32_t> depths_a; ///< Ascending.
    std::uint32_t depth_b = 6;
    unsigned passes = 3;           ///< Over the scenarios; times are medians.
    std::filesystem::path scratch; ///< A folder for blocks; they are left there.
};

/// What is recorded stands in trace.hpp. Takes the trees' binary form alone, as a master does, and
/// makes wide trees where it needs them; all depths are in memory at once. Prints a line for each
/// depth. Errors: Io.
[[nodiscard]] Result<Trace> record_trace(const std::shared_ptr<const ObbTree>& a,
                                         const std::shared_ptr<const ObbTree>& b,
                                         const std::vector<Scenario>& scenarios,
                                         const RecordOptions& options);

} // namespace cd::bench
