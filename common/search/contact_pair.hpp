// Pairs of triangles that a search finds, and their order.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/geometry/types.hpp"
#include "common/pair/triangle_pair.hpp"

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

namespace cd {

/// Triangles `a` of A and `b` of B that share a point or, with class Near, are within the query's
/// clearance; by their indices in the meshes.
struct ContactPair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    PairClass kind = PairClass::Touch;

    friend auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

/// Sorts pairs in ascending order. Keeps scratch memory between calls; one thread at a time may use
/// a sorter.
class PairSorter {
  public:
    PairSorter();
    PairSorter(PairSorter&&) noexcept;
    PairSorter& operator=(PairSorter&&) noexcept;
    ~PairSorter();

    /// Sorts pairs whose indices are below `limits::mesh_triangles_max`.
    void sort(std::vector<ContactPair>& pairs);
    /// Sorts the pairs and moves the corners of each pair along with it. The pairs' indices are
    /// below `limits::mesh_triangles_max`.
    void sort(std::vector<ContactPair>& pairs, std::vector<PairCorners>& corners);

  private:
    struct Scratch;
    std::unique_ptr<Scratch> scratch_;
};

} // namespace cd
