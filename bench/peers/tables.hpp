// Writes the results of the comparison as CSV files.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/peers/contest.hpp"
#include "bench/peers/scenes.hpp"

#include <filesystem>
#include <span>

namespace cd::bench {

struct Tables {
    CsvFile scenes;  ///< One row per scene.
    CsvFile engines; ///< One row per engine and scene; ratios are to the first engine.

    explicit Tables(const std::filesystem::path& folder);

    void add(const SceneSource& source,
             const Scene& scene,
             const Reference& reference,
             std::span<const Outcome> outcomes);
};

} // namespace cd::bench
