// Our engine on one thread and on two.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <chrono>
#include <cstddef>

namespace cd::bench {

struct ThreadOptions {
    std::size_t rounds = 5;
    /// Passes are repeated until they take this long on one thread: shorter runs are too noisy.
    double run_seconds = 0.5;
    std::chrono::seconds limit{120};
};

/// Searches all pairs of a scene's poses, on one thread and on two that share the trees, in turn.
/// Writes a row for each round.
void run_threads(const std::string& suite,
                 const Scene& scene,
                 const Engine& ours,
                 const ThreadOptions& options,
                 CsvFile& csv);
[[nodiscard]] CsvFile open_threads_csv(const std::filesystem::path& folder);

/// Builds a mesh's tree on one thread and on two, in turn. Writes a row for each round.
void run_builds(const std::string& name,
                const std::shared_ptr<const Mesh>& mesh,
                const ThreadOptions& options,
                CsvFile& csv);
[[nodiscard]] CsvFile open_builds_csv(const std::filesystem::path& folder);

} // namespace cd::bench
