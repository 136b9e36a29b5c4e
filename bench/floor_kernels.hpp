// The three kernels that every search needs, each in its barest form with all its data in the first
// cache: a lower bound for whole queries.
#pragma once

#include <cstdint>
#include <memory>

namespace cd::bench {

/// Number of inputs that each kernel leaves. Equal on every SIMD target.
struct FloorCounts {
    std::uint64_t looked_at = 0;
    std::uint64_t left = 0;
};

/// Fixed inputs, and the kernels on them, for the SIMD target in use. The kernels lack the margins,
/// the descent and the memory accesses of a real search.
class FloorKernels {
  public:
    FloorKernels();
    FloorKernels(const FloorKernels&) = delete;
    FloorKernels& operator=(const FloorKernels&) = delete;
    ~FloorKernels();

    /// Tests sixteen boxes in one frame against sixteen in another, on the six axes of both, each
    /// box transformed to the other frame; lists the overlapping pairs.
    FloorCounts boxes();
    /// Tests gathered pairs of triangles: is one wholly on a side of the other's plane? Uses floats
    /// with an error bound; lists the pairs that are not separated.
    FloorCounts sides();
    /// Runs the decision's float stage (float_triangle_pair.hpp) on the pairs that `sides` leaves.
    FloorCounts decision();

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

/// Time of one box test, one side test and one decision.
struct FloorTimes {
    double box_ns = 0;
    double side_ns = 0;
    double decision_ns = 0;
};

/// Returns the best times of many runs.
[[nodiscard]] FloorTimes measure_floor();

} // namespace cd::bench
