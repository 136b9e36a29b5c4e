// Costs of results from a worker's search to the master's disk, measured with the code of both.
#pragma once

#include "bench/cluster/trace/trace.hpp"
#include "common/core/files/bytes.hpp"
#include "master/compute/result_check.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace cd::bench {

/// Takes analysed scenarios with their records from a worker, in that order, and packs as many into
/// a message as a worker does. Makes a new journal in the folder, which is not deleted; nothing is
/// synced, since waiting for a disk takes no processor time. Returns means over the scenarios of
/// the passes' medians. Errors: Io; BadFrame for invalid records.
[[nodiscard]] Result<ResultCosts>
measure_result_costs(const std::shared_ptr<const JobMaterial>& material,
                     std::span<const Analysis> analyses,
                     std::span<const Bytes> records,
                     const std::filesystem::path& folder,
                     unsigned passes);

} // namespace cd::bench
