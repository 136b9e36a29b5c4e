// Coarse answers: what a tolerance or a cut of the trees saves, and how far off its bound is.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace cd::bench {

struct CoarseOptions {
    std::vector<double> tolerances{0.1, 0.03, 0.01, 0.003, 0.001}; ///< Shares of A's diagonal.
    std::vector<std::uint32_t> cuts{4, 6, 8, 10, 12};              ///< Depths of both trees.
    std::size_t rounds = 5;
};

/// Asks for any contact at each setting and exactly; compares with the truth and, where the bodies
/// are apart, with their distance. Settings are timed in turn. Writes a row a setting.
void run_coarse(const Scene& scene,
                std::span<const TrueContacts> truth,
                const CoarseOptions& options,
                CsvFile& csv);

[[nodiscard]] CsvFile open_coarse_csv(const std::filesystem::path& folder);

} // namespace cd::bench
