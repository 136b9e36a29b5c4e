// The three kernels that a search cannot do without, each in its barest form and with all that it
// reads in the first cache: what a whole query is held against.
#pragma once

#include <cstdint>
#include <memory>

namespace cd::bench {

/// How many of what they looked at they leave. The same on every SIMD target.
struct FloorCounts {
    std::uint64_t looked_at = 0;
    std::uint64_t left = 0;
};

/// Fixed inputs, and the kernels on them, by the SIMD target in use. None has the margins, the
/// walk or the memory of a real search.
class FloorKernels {
  public:
    FloorKernels();
    FloorKernels(const FloorKernels&) = delete;
    FloorKernels& operator=(const FloorKernels&) = delete;
    ~FloorKernels();

    /// Sixteen boxes in one frame against sixteen in another, on the six axes of both, each box
    /// put into the other frame; pairs that overlap are listed.
    FloorCounts boxes();
    /// Pairs of triangles, gathered: is one wholly on a side of the other's plane? In floats with
    /// an error bound; pairs that are not are listed.
    FloorCounts sides();
    /// The float stage of the decision (float_triangle_pair.hpp) on pairs that `sides` leaves.
    FloorCounts decision();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// What one box test, one look at sides and one decision take.
struct FloorTimes {
    double box_ns = 0;
    double side_ns = 0;
    double decision_ns = 0;
};

/// Of the best of many runs.
[[nodiscard]] FloorTimes measure_floor();

} // namespace cd::bench
