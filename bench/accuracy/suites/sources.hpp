// The inputs of the report: hard pairs by category, whole-mesh scenes, vehicles.
#pragma once

#include "bench/accuracy/suites/pair_batch.hpp"
#include "bench/accuracy/suites/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cd::bench {

/// Returns the pairs `first` to `first + count - 1` of a category.
[[nodiscard]] PairBatch
corpus_batch(const std::string& category, std::uint64_t first, std::uint64_t count);

/// Returns up to `scenes_max` whole-mesh scenes of the corpus, evenly spread.
[[nodiscard]] std::vector<Scene> hard_scenes(std::size_t scenes_max);

/// Returns two tori of 9,216 triangles in random poses, about half of them apart.
[[nodiscard]] Scene torus_scene(std::uint64_t poses);

/// A mesh file and its unit in metres.
struct Model {
    const char* file;
    double unit = 1;
};

/// Returns null, with a line on stderr, if the file is missing or unreadable.
[[nodiscard]] std::shared_ptr<const Mesh> load_model(const std::filesystem::path& folder,
                                                     const Model& model);

/// Returns the number of vehicle couples.
[[nodiscard]] std::size_t vehicle_scene_count();

/// Places real models against each other: `scenarios` random poses in contact, up to 5 % deep, each
/// also with B moved off by up to a fifth of A's diagonal. Returns nothing, with a line on stderr,
/// if a model is missing.
[[nodiscard]] std::optional<Scene>
vehicle_scene(const std::filesystem::path& models, std::size_t couple, std::uint64_t scenarios);

/// Candidates of every pose of a scene, with their trees, in the order of a search of the wide
/// trees. Bodies without wide trees are searched in binary ones.
class SceneCandidates {
  public:
    explicit SceneCandidates(const Scene& scene);

    [[nodiscard]] PairBatch batch() const;

  private:
    void add_from_wide(const PosePair& poses);

    const Scene* scene_;
    ObbTree a_;
    ObbTree b_;
    /// Candidates by position in the mesh or binary tree.
    std::vector<std::vector<Candidate>> candidates_;
    /// Candidates by position in the leaves of the wide trees.
    std::vector<std::vector<Candidate>> places_;
};

} // namespace cd::bench
