#include "common/job/tolerance.hpp"

#include "common/core/limits/engine.hpp"

#include <cmath>
#include <string>

namespace cd {

namespace {

constexpr std::size_t triangles_of_root = 1024;

} // namespace

Status check_tolerance(double tolerance) {
    if (!std::isfinite(tolerance) || tolerance < 0) {
        return Error{ErrorCode::BadInput,
                     "the tolerance is " + std::to_string(tolerance) +
                         "; it has to be a finite length of at least 0"};
    }
    return Done{};
}

std::uint32_t tolerance_depth(const ObbTree& tree) {
    const std::size_t triangles = tree.mesh().triangles().size();
    std::uint32_t depth = 0;
    while (depth < limits::distribution_depth_max && triangles >> depth > triangles_of_root) {
        ++depth;
    }
    return depth;
}

} // namespace cd
