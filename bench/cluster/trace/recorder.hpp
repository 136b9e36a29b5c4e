// Measures a job's costs with the code of the master and the worker.
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
    unsigned passes = 3;           ///< Passes over the scenarios; times are medians.
    std::filesystem::path scratch; ///< A folder for blocks, which are not deleted.
};

/// Records a trace (trace.hpp). Takes binary trees only, as a master does, and makes wide trees
/// where needed; all depths are in memory at once. Prints a line for each depth. Errors: Io.
[[nodiscard]] Result<Trace> record_trace(const std::shared_ptr<const ObbTree>& a,
                                         const std::shared_ptr<const ObbTree>& b,
                                         const std::vector<Scenario>& scenarios,
                                         const RecordOptions& options);

} // namespace cd::bench
