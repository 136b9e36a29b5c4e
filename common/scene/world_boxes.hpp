// World boxes of many bodies at once, with SIMD.
#pragma once

#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"
#include "common/scene/world_box.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace cd {

struct PosedBoxColumns;

/// Computes world boxes in blocks of bodies. Each is the same, bit for bit, as that of `world_box`,
/// on every SIMD target.
class WorldBoxes {
  public:
    /// Expects about `count` bodies.
    explicit WorldBoxes(std::size_t count);
    ~WorldBoxes();

    /// Adds a body, with the arguments of `world_box`.
    void add(const Aabb& body, const Pose& pose, double margin = 0);
    /// Returns the boxes of all bodies in the order of `add`. Call it once, at the end.
    [[nodiscard]] std::vector<WorldBox> take();

  private:
    void flush();

    std::unique_ptr<PosedBoxColumns> columns_; ///< Of bodies without a box yet.
    std::vector<WorldBox> boxes_;
};

} // namespace cd
