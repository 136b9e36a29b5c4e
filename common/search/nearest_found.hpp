// The nearest pair that a search finds, from the exact distances of its candidates.
#pragma once

#include "common/distance/triangle_distance.hpp"
#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/tree/ignored_range.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// Triangles `a` of A and `b` of B, by their indices in the meshes, and their distance in the
/// world, correctly rounded.
struct NearestPair {
    double distance = 0;
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    PairCorners corners;
};

/// Keeps the nearest of all candidates: the one with the least rounded distance, and among equal
/// ones with the least indices of A, then of B. So the pair does not depend on the order of the
/// candidates. No candidate may share a point. One thread at a time may use an instance.
class NearestFound {
  public:
    /// Pairs farther apart than `up_to` do not count.
    NearestFound(const PosePair& poses, DistanceStage first, double up_to);

    /// Takes other poses of the same bodies. The pair found last becomes the first candidate, since
    /// it is mostly among the nearest ones of a neighbouring pose.
    void restart(const PosePair& poses);
    /// Forgets the pair found last if it is ignored.
    void forget_ignored(std::span<const IgnoredRange> ignored);

    /// Adds candidates of two bodies, each a TriangleSpan or TriangleBlocks. `ids_a` and `ids_b`
    /// map the candidates' indices to triangles of the meshes.
    template <class Triangles>
    void add(const Triangles& a,
             std::span<const std::uint32_t> ids_a,
             const Triangles& b,
             std::span<const std::uint32_t> ids_b,
             std::span<const Candidate> candidates);

    /// Decides the candidates that bounds in floats leave open. `best` and `points_of` are right
    /// after this call.
    void settle();

    /// Returns a distance such that farther pairs cannot change the answer: their distance would
    /// round to more than the best one.
    [[nodiscard]] double bound() const;

    /// Returns about the vector between the nearest points of the best pair so far, in the world,
    /// or zero before there is one.
    [[nodiscard]] const Vec3& displacement() const { return displacement_; }

    [[nodiscard]] const std::optional<NearestPair>& best() const { return best_; }
    /// Returns the nearest points of a pair under the current poses.
    [[nodiscard]] NearestPoints points_of(const NearestPair& pair) {
        return distance_.nearest(pair.corners.a, pair.corners.b);
    }
    [[nodiscard]] std::uint64_t triangle_tests() const { return triangle_tests_; }

  private:
    void decide(const NearestPair& pair);

    TriangleDistance distance_;
    double up_to_;
    std::optional<NearestPair> best_;
    double upper_ = std::numeric_limits<double>::infinity(); ///< Of the least distance, in floats.
    Vec3 displacement_ = Vec3::Zero();
    /// Candidates that are not decided. Their `distance` is a lower bound.
    std::vector<NearestPair> open_;
    std::uint64_t triangle_tests_ = 0;
};

} // namespace cd
