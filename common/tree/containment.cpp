#include "common/tree/containment.hpp"

#include "common/tree/box_test.hpp"
#include "common/tree/posed_point.hpp"

#include <algorithm>

namespace cd {

bool contains_component(const ObbTree& outer,
                        const Pose& outer_pose,
                        const ObbTree& inner,
                        const Pose& inner_pose,
                        const InsideProbes& probes,
                        SettleStatistics& statistics) {
    const RelativePose inner_to_outer = relative_pose({outer_pose, inner_pose});
    if (!BoxTest(inner_to_outer).may_overlap(outer.nodes()[0], inner.nodes()[0])) {
        return false;
    }
    const ExactFrame frame(outer_pose, inner_pose);
    if (!frame.has_inverse()) {
        return false; // Nothing is strictly inside a body without volume.
    }
    SolidTest solid(outer);
    const auto is_inside = [&](std::uint32_t triangle, std::span<const IdRange> left_out) {
        const Vec3 corner = inner.mesh().corners(triangle)[0];
        const RoundedPoint rounded = posed(inner_to_outer, corner);
        SolidPoint point(rounded.value, rounded.error, [&] {
            return ExactPoint{frame.of_inner(corner), frame.scale()};
        });
        return solid.place_of(point, left_out) == Place::Inside;
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
