// Coarse answers: the time saved by a cut, and the error of the bound.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace cd::bench {

struct CoarseOptions {
    std::vector<std::uint32_t> cuts{4, 6, 8, 10, 12}; ///< Depths of both trees.
    std::size_t rounds = 5;
};

/// Queries any contact at each setting and exactly, and compares with the truth and, for bodies
/// apart, with their distance. Settings are timed in turn. Writes a row for each setting.
void run_coarse(const Scene& scene,
                std::span<const TrueContacts> truth,
                const CoarseOptions& options,
                CsvFile& csv);

[[nodiscard]] CsvFile open_coarse_csv(const std::filesystem::path& folder);

} // namespace cd::bench
