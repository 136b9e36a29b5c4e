// How lines pass through the parts of a body.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/groups/body_parts.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/job/result/result.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cd {

/// Where a line crosses the surface of a part.
struct Crossing {
    std::uint32_t triangle = 0;
    double depth = 0; ///< From the line's start, in the job's unit.
};

/// A line's way through a part: from where it enters to where it leaves. Where the part has no
/// inside, it is only where the line crosses the surface.
struct Passage {
    std::uint32_t line = 0;
    std::uint32_t part = 0; ///< Of `BodyParts`.
    Crossing in;
    std::optional<Crossing> out;

    /// Returns the length of the way; nothing without an end.
    [[nodiscard]] std::optional<double> thickness() const {
        return out ? std::optional(out->depth - in.depth) : std::nullopt;
    }
};

/// Finds the passages of lines through the parts of a mesh. Those of a part whose surface is closed
/// pair its crossings in their order along the line, two by two: a line that starts and ends
/// outside crosses it an even number of times. Passages without an end, of which no thickness is
/// invented, are the crossings of an open part, those of a line that may start or end inside the
/// part, one that is left over, and all of a result that lists not every hit.
class PassageFinder {
  public:
    /// `lines` are those of a file, in the world's coordinates; null for a grid, whose lines start
    /// and end outside. Takes near-linear time in the number of triangles.
    explicit PassageFinder(const Mesh& mesh, std::shared_ptr<const Mesh> lines = nullptr);

    [[nodiscard]] const BodyParts& parts() const { return parts_; }
    [[nodiscard]] bool is_closed(std::uint32_t part) const { return are_closed_[part]; }

    /// Returns the passages of a result of Question::Shots by line, and of each line by where they
    /// begin. `pose` is that of the mesh; without one it stands at the identity.
    [[nodiscard]] std::vector<Passage> passages(const ScenarioResult& result,
                                                const std::optional<Pose>& pose = {}) const;

  private:
    [[nodiscard]] bool starts_and_ends_outside(std::uint32_t line,
                                               std::uint32_t part,
                                               const std::optional<Pose>& pose) const;

    BodyParts parts_;
    std::vector<bool> are_closed_; ///< Of each part, whether its triangles bound a solid.
    std::vector<Aabb> boxes_;      ///< Of each part.
    std::shared_ptr<const Mesh> lines_;
};

/// Makes the finder for body A and the lines of a job.
[[nodiscard]] std::shared_ptr<const PassageFinder>
make_finder(const Mesh& a, const std::shared_ptr<const Mesh>& lines, const ShotViews& views);

} // namespace cd
