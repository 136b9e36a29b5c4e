// The pairs of a scene as our exact engine finds them, which every other engine is held against.
#pragma once

#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/suites/scene.hpp"
#include "bench/peers/engines/engine.hpp"

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

/// Sorted, each pair once.
using PairSet = std::vector<IdPair>;

[[nodiscard]] PairSet pair_set(MeshAnswer answer);

/// Kept in memory that children share. The bodies' triangles number below 2^32.
class Reference {
  public:
    /// Asks `ours` in a child. Throws if that fails: without it there is no report.
    Reference(const Scene& scene, const Engine& ours, std::chrono::seconds limit);

    [[nodiscard]] std::size_t pose_count() const { return ends_.values().size() - 1; }
    [[nodiscard]] std::uint64_t pair_count(std::size_t pose) const;
    [[nodiscard]] PairSet pairs(std::size_t pose) const;

  private:
    SharedArray<std::uint64_t> keys_; ///< a * 2^32 + b, pose after pose.
    SharedArray<std::uint64_t> ends_; ///< Of each pose's keys; a 0 before the first.
};

/// A pair on which an engine and ours differ.
struct Disagreement {
    std::uint64_t pose;
    std::uint32_t a;
    std::uint32_t b;
    bool is_extra; ///< Only the engine has it; else only ours has.
};

/// All of one pose, missing ones first.
[[nodiscard]] std::vector<Disagreement>
disagreements(const Reference& reference, std::size_t pose, const PairSet& found);

/// In how many of them the exact oracle finds that ours is the one that is wrong.
[[nodiscard]] std::uint64_t ours_wrong(const Scene& scene, std::span<const Disagreement> judged);

} // namespace cd::bench
