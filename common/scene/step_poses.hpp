// The bodies of a scene, and their poses step by step.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// A body of a scene.
struct PlacedBody {
    Aabb box;              ///< Of its mesh, in its coordinates; not empty.
    bool is_fixed = false; ///< Its pose is the same at all steps, and it is never absent.
    double radius = 0;     ///< Of its mesh (`body_radius`); used for motions alone.
    std::string name = {}; ///< In messages.
};

/// The poses of all bodies at a step, by the bodies' indices: nothing for a body that is absent.
using PosesOfStep = std::vector<std::optional<Pose>>;

/// The poses of a scene's bodies, step by step.
class StepPoses {
  public:
    StepPoses() = default;
    StepPoses(const StepPoses&) = delete;
    StepPoses& operator=(const StepPoses&) = delete;
    virtual ~StepPoses() = default;

    /// Number of steps, at least 1.
    [[nodiscard]] virtual std::uint64_t steps() const = 0;
    /// Reads the poses at a step, which exists. The result depends on the step alone. Errors: Io;
    /// BadInput naming the row.
    [[nodiscard]] virtual Result<PosesOfStep> read(std::uint64_t step) = 0;
    /// Returns the time of each step, in the unit of the user's file; empty if none are given.
    [[nodiscard]] virtual std::vector<double> times() const { return {}; }
};

} // namespace cd
