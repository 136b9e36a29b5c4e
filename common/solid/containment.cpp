#include "common/solid/containment.hpp"

#include "common/solid/posed_point.hpp"

#include <algorithm>
#include <optional>

namespace cd {

namespace {

/// The exact frame of two bodies, made on first use because it costs more than most searches.
class LateFrame {
  public:
    LateFrame(const Pose& outer, const Pose& inner) : outer_(outer), inner_(inner) {}

    [[nodiscard]] const ExactFrame& get() {
        if (!frame_) {
            frame_.emplace(outer_, inner_);
        }
        return *frame_;
    }
    [[nodiscard]] bool has_inverse() {
        const Mat3 matrix = outer_.rotation();
        return proven_volume_sign({matrix.col(0), matrix.col(1), matrix.col(2)},
                                  outer_.rotation_error()) ||
               get().has_inverse();
    }

  private:
    const Pose& outer_;
    const Pose& inner_;
    std::optional<ExactFrame> frame_;
};

} // namespace

bool contains_component(const ObbTree& outer,
                        const Pose& outer_pose,
                        const ObbTree& inner,
                        const Pose& inner_pose,
                        const InsideProbes& probes,
                        SettleStatistics& statistics) {
    const RelativePose inner_to_outer = relative_pose({outer_pose, inner_pose});
    LateFrame frame(outer_pose, inner_pose);
    if (!frame.has_inverse()) {
        return false; // Nothing is strictly inside a body without volume.
    }
    SolidTest solid(outer);
    const auto is_inside = [&](std::uint32_t triangle, std::span<const IdRange> left_out) {
        const Vec3 corner = inner.mesh().corners(triangle)[0];
        const RoundedPoint rounded = posed(inner_to_outer, corner);
        SolidPoint point(rounded.value, rounded.error, [&] {
            return ExactPoint{frame.get().of_inner(corner), frame.get().scale()};
        });
        return solid.locate(point, left_out) == Location::Inside;
    };
    const bool contains = std::ranges::any_of(probes.groups, [&](const ProbeGroup& group) {
        return std::ranges::any_of(group.triangles, [&](std::uint32_t triangle) {
            return is_inside(triangle, group.left_out);
        });
    });
    statistics += solid.statistics();
    return contains;
}

} // namespace cd
