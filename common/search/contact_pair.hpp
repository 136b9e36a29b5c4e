// Pairs of triangles that share a point, and how they are put in order.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/triangle_pair.hpp"

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// Triangles `a` of A and `b` of B that share a point, by their places in their meshes.
struct ContactPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    PairClass kind = PairClass::Touch;

    friend auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

/// The corners of one found pair, each in its body's coordinates.
struct PairCorners {
    Corners a;
    Corners b;
};

/// Sorts pairs, ascending. Keeps scratch memory between calls; one thread at a time.
class PairSorter {
  public:
    PairSorter();
    PairSorter(PairSorter&&) noexcept;
    PairSorter& operator=(PairSorter&&) noexcept;
    ~PairSorter();

    /// Places in meshes are below `limits::mesh_triangles_max`.
    void sort(std::vector<ContactPair>& pairs);
    /// The same, each pair with its corners.
    void sort(std::vector<ContactPair>& pairs, std::vector<PairCorners>& corners);

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

} // namespace cd
