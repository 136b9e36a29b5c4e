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

/// The pairs `first` to `first + count - 1` of a category.
[[nodiscard]] PairBatch
corpus_batch(const std::string& category, std::uint64_t first, std::uint64_t count);

/// Up to `scenes_max` of the corpus's whole-mesh scenes, evenly spread.
[[nodiscard]] std::vector<Scene> hard_scenes(std::size_t scenes_max);

/// Two tori of 9,216 triangles in random poses, about half of them clear of each other.
[[nodiscard]] Scene torus_scene(std::uint64_t poses);

/// A file of a mesh, with the metres in a unit of it.
struct Model {
    const char* file;
    double unit = 1;
};

/// Null, and said on stderr, where the file is not in the folder or cannot be read.
[[nodiscard]] std::shared_ptr<const Mesh> load_model(const std::filesystem::path& folder,
                                                     const Model& model);

/// How many couples of vehicles there are.
[[nodiscard]] std::size_t vehicle_scene_count();

/// Real models against each other: `scenarios` random poses in contact, up to 5 % deep, each also
/// with B moved off by up to a fifth of A's diagonal. Nothing, and said on stderr, where a model is
/// not in the folder.
[[nodiscard]] std::optional<Scene>
vehicle_scene(const std::filesystem::path& models, std::size_t couple, std::uint64_t scenarios);

/// The candidates of every pose of a scene, with the trees that they refer to: those that a search
/// of the wide trees decides, in its order. Bodies that have no wide trees are searched in binary
/// ones.
class SceneCandidates {
  public:
    explicit SceneCandidates(const Scene& scene);

    [[nodiscard]] PairBatch batch() const;

  private:
    void add_from_wide(const PosePair& poses);

    const Scene* scene_;
    ObbTree a_;
    ObbTree b_;
    std::vector<std::vector<Candidate>> candidates_; ///< By places in the mesh or binary tree,
    std::vector<std::vector<Candidate>> places_;     ///< and in the leaves of the wide trees.
};

} // namespace cd::bench
