// Compares an engine's hits with those of ours, and ours with the exact oracle.
#pragma once

#include "bench/peers/shots/shot_engine.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd::bench {

/// All hits of a scene, by line and depth.
class HitsByLine {
  public:
    HitsByLine(std::vector<ShotHit> hits, std::uint32_t lines);

    [[nodiscard]] std::uint32_t lines() const {
        return static_cast<std::uint32_t>(begins_.size() - 1);
    }
    [[nodiscard]] std::span<const ShotHit> of(std::uint32_t line) const {
        return std::span(hits_).subspan(begins_[line], begins_[line + 1] - begins_[line]);
    }

  private:
    std::vector<ShotHit> hits_;
    std::vector<std::size_t> begins_; ///< The first hit of each line, and the number of hits.
};

/// How an engine's hits differ from the crossings of ours.
struct HitErrors {
    std::uint64_t missing = 0;
    std::uint64_t doubled = 0; ///< Hits too many.

    [[nodiscard]] bool is_none() const { return missing == 0 && doubled == 0; }
    HitErrors& operator+=(const HitErrors& other);
};

/// Compares the hits of one line. At each point where the line meets triangles, an engine is right
/// with as many hits as ours has crossings, whichever of the triangles that share the point it
/// names; so another rule for lines through edges and corners costs nothing. A hit of a triangle
/// that the line does not meet is one too many.
[[nodiscard]] HitErrors compare_hits(std::span<const ShotHit> ours,
                                     std::span<const ShotHit> theirs);

/// Whether ours are exactly the oracle's hits among the triangles that ours and theirs name.
[[nodiscard]] bool is_right(const Mesh& mesh,
                            const PosedLine& line,
                            std::span<const ShotHit> ours,
                            std::span<const ShotHit> theirs);

} // namespace cd::bench
