// The inputs of the report: hard pairs by category, whole-mesh scenes, vehicles.
#pragma once

#include "bench/accuracy/pair_batch.hpp"
#include "bench/accuracy/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cd::bench {

[[nodiscard]] std::vector<std::string> corpus_categories();

/// The pairs `first` to `first + count - 1` of a category.
[[nodiscard]] PairBatch
corpus_batch(const std::string& category, std::uint64_t first, std::uint64_t count);

/// Scenes where touching is the normal case: solids laid against each other.
[[nodiscard]] std::vector<Scene> tie_scenes();

/// Real models against each other in `scenarios` random poses, from clear to 5 % deep. A model that
/// is not in the folder is said on stderr, and its scenes are left out.
[[nodiscard]] std::vector<Scene> vehicle_scenes(const std::filesystem::path& models,
                                                std::uint64_t scenarios);

/// The candidates of every pose of a scene, with the trees that they refer to.
class SceneCandidates {
  public:
    explicit SceneCandidates(const Scene& scene);

    [[nodiscard]] PairBatch batch() const;

  private:
    const Scene* scene_;
    ObbTree a_;
    ObbTree b_;
    std::vector<std::vector<Candidate>> candidates_;
};

} // namespace cd::bench
