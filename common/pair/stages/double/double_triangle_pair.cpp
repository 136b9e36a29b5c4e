#include "common/pair/stages/double/double_triangle_pair.hpp"

#include "common/pair/poses/plain_poses.hpp"

namespace cd {

DoubleTrianglePair::DoubleTrianglePair(const PosePair& poses, double bound_scale)
    : poses_(plain_poses(poses)), bound_scale_(bound_scale) {}

std::optional<PairClass> DoubleTrianglePair::classify(const Corners& a, const Corners& b) const {
    return with_signs(a, b, [](const auto& signs) {
        ProvenSigns proven(signs);
        const PairClass kind = decide_pair(proven);
        return proven.are_enough() ? std::optional(kind) : std::nullopt;
    });
}

} // namespace cd
