// What results cost on their way from a worker's search to the master's disk, measured by the code
// of both.
#pragma once

#include "bench/cluster/trace/trace.hpp"
#include "common/core/files/bytes.hpp"
#include "master/results/result_intake.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace cd::bench {

/// Of scenarios that were analysed, with the record that a worker made of each, in the same order;
/// as many together in a message as a worker sends of such scenarios. The journal is a new one in
/// the folder, and is left there; nothing is synced, since waiting for a disk takes no processor.
/// Means over the scenarios, of the passes' medians. Errors: Io; BadFrame for records that are
/// none.
[[nodiscard]] Result<ResultCosts>
measure_result_costs(const std::shared_ptr<const JobMaterial>& material,
                     std::span<const Analysis> analyses,
                     std::span<const Bytes> records,
                     const std::filesystem::path& folder,
                     unsigned passes);

} // namespace cd::bench
