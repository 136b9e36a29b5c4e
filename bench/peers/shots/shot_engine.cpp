#include "bench/peers/shots/shot_engine.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <stdexcept>

namespace cd::bench {

bool is_float_number(double value) {
    // A float has 24 of the 53 binary digits. GCC 12 drops some casts to float and back.
    constexpr std::uint64_t digits_of_double_alone = (std::uint64_t{1} << 29) - 1;
    return (std::bit_cast<std::uint64_t>(value) & digits_of_double_alone) == 0;
}

std::uint32_t ShotScene::line_count() const {
    std::size_t count = 0;
    for (const ShotBundle& bundle : bundles) {
        count += bundle.poses.size() * bundle.lines->triangles().size();
    }
    return static_cast<std::uint32_t>(count);
}

std::vector<PosedLine> posed_lines(const ShotScene& scene) {
    std::vector<PosedLine> lines;
    for (const ShotBundle& bundle : scene.bundles) {
        for (const Pose& pose : bundle.poses) {
            for (std::uint32_t i = 0; i < bundle.lines->triangles().size(); ++i) {
                const Corners ends = bundle.lines->corners(i);
                lines.push_back({{ends[0], ends[1]}, pose});
            }
        }
    }
    return lines;
}

std::vector<Segment> world_lines(const ShotScene& scene) {
    std::vector<Segment> lines;
    for (const auto& [segment, pose] : posed_lines(scene)) {
        const Segment line{pose.apply(segment.p), pose.apply(segment.q)};
        for (const Vec3& numbers : {line.p, line.q, Vec3(line.q - line.p)}) {
            if (!std::all_of(numbers.begin(), numbers.end(), is_float_number)) {
                throw std::runtime_error("a line of " + scene.body + " is not one of floats");
            }
        }
        lines.push_back(line);
    }
    return lines;
}

} // namespace cd::bench
