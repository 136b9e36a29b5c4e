// A common interface of engines that find all hits of lines on a mesh.
#pragma once

#include "common/geometry/mesh.hpp"
#include "common/geometry/pose.hpp"
#include "common/shots/line_hit.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cd::bench {

/// Whether a float holds the number, which is 0 or neither tiny nor huge.
[[nodiscard]] bool is_float_number(double value);

/// Lines as a mesh of segments, at one or more poses.
struct ShotBundle {
    std::shared_ptr<const Mesh> lines;
    std::vector<Pose> poses; ///< From the bundle's coordinates to the world.
};

/// A body, and lines through it. All coordinates in the world are floats, so that no engine has to
/// round its input. Lines are numbered by bundle, pose and triangle.
struct ShotScene {
    std::string body;
    std::string kind; ///< Of lines.
    bool is_closed = false;
    std::shared_ptr<const Mesh> mesh; ///< Its coordinates are the world's.
    std::vector<ShotBundle> bundles;

    [[nodiscard]] std::uint32_t line_count() const;
};

/// A line of a scene: the segment in its bundle's coordinates, and the bundle's pose.
struct PosedLine {
    Segment segment;
    Pose pose;
};

/// Returns all lines of a scene by their numbers.
[[nodiscard]] std::vector<PosedLine> posed_lines(const ShotScene& scene);

/// Returns all lines in the world. Throws if a coordinate is no float, since then engines that
/// compute in floats would not get the same lines.
[[nodiscard]] std::vector<Segment> world_lines(const ShotScene& scene);

/// A line that meets a triangle.
struct ShotHit {
    std::uint32_t line = 0;
    std::uint32_t triangle = 0;
    double depth = 0; ///< From the line's start.
    // Of our engine alone:
    std::uint8_t flags = 0; ///< See `hit_flag`.
    std::uint8_t rank = 0;  ///< See `LineHit`.
};

/// A body that lines are shot at.
class ShotBody {
  public:
    ShotBody() = default;
    ShotBody(const ShotBody&) = delete;
    ShotBody& operator=(const ShotBody&) = delete;
    virtual ~ShotBody() = default;

    /// Builds everything that is built once. The scene outlives this object.
    virtual void load(const ShotScene& scene) = 0;
    /// Appends all hits of all lines, in any order.
    virtual void shoot(std::vector<ShotHit>& hits) = 0;
};

/// An engine with one setting.
struct ShotEngine {
    std::string name;
    bool is_ours = false;
    std::function<std::unique_ptr<ShotBody>()> make_body;
};

/// Appends Embree: robust or not with single rays, and robust with packets of 8 and 16.
void add_embree_shots(std::vector<ShotEngine>& engines);

/// Returns our engine: the scenarios of a job of shot lines at level pairs.
[[nodiscard]] ShotEngine our_shots();

} // namespace cd::bench
