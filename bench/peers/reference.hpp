// Reference pairs of a scene, found by our exact engine; other engines are compared with them.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/scene.hpp"
#include "bench/peers/engines/engine.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

/// Sorted and unique.
using PairSet = std::vector<IdPair>;

[[nodiscard]] PairSet pair_set(MeshAnswer answer);

/// Kept in memory shared with children. Each body has fewer than 2^32 triangles.
class Reference {
  public:
    /// Runs `ours` in a child. Throws if that fails: without a reference there is no report.
    Reference(const Scene& scene, const Engine& ours, std::chrono::seconds limit);

    [[nodiscard]] std::size_t pose_count() const { return ends_.values().size() - 1; }
    [[nodiscard]] std::uint64_t pair_count(std::size_t pose) const;
    [[nodiscard]] PairSet pairs(std::size_t pose) const;

  private:
    SharedArray<std::uint64_t> keys_; ///< a * 2^32 + b, pose after pose.
    SharedArray<std::uint64_t> ends_; ///< End of each pose's keys, after a leading 0.
};

/// A pair on which an engine and the reference differ.
struct Disagreement {
    std::uint64_t pose;
    std::uint32_t a;
    std::uint32_t b;
    bool is_extra; ///< Only the engine reports the pair; otherwise only the reference does.
};

/// Returns all disagreements of one pose, missing pairs first.
[[nodiscard]] std::vector<Disagreement>
disagreements(const Reference& reference, std::size_t pose, const PairSet& found);

/// Returns in how many of them the exact oracle contradicts the reference.
[[nodiscard]] std::uint64_t ours_wrong(const Scene& scene, std::span<const Disagreement> judged);

} // namespace cd::bench
