// Our engine on one thread and on two.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <chrono>
#include <cstddef>

namespace cd::bench {

struct ThreadOptions {
    std::size_t rounds = 5;
    /// As many passes over the poses as take so long on one thread: a shorter run says little.
    double run_seconds = 0.5;
    std::chrono::seconds limit{120};
};

/// All pairs of a scene's poses, shared out to one thread and to two that search the same trees, in
/// turn; a row a round.
void run_threads(const std::string& suite,
                 const Scene& scene,
                 const Engine& ours,
                 const ThreadOptions& options,
                 CsvFile& csv);
[[nodiscard]] CsvFile open_threads_csv(const std::filesystem::path& folder);

/// What a mesh's tree takes to build on one thread and on two, in turn; a row a round.
void run_builds(const std::string& name,
                const std::shared_ptr<const Mesh>& mesh,
                const ThreadOptions& options,
                CsvFile& csv);
[[nodiscard]] CsvFile open_builds_csv(const std::filesystem::path& folder);

} // namespace cd::bench
