// The outcome of the comparison as CSV files.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/peers/contest.hpp"
#include "bench/peers/scenes.hpp"

#include <filesystem>
#include <span>

namespace cd::bench {

struct Tables {
    CsvFile scenes;  ///< A row a scene.
    CsvFile engines; ///< A row an engine and scene; ratios are against the first engine.
    CsvFile poses;   ///< A row an engine, scene and pose.

    explicit Tables(const std::filesystem::path& folder);

    void add(const SceneSource& source,
             const Scene& scene,
             const Reference& reference,
             std::span<const Outcome> outcomes);
};

} // namespace cd::bench
