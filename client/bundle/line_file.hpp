// Reads lines from files of numbers.
#pragma once

#include "client/bundle/line_bundle.hpp"
#include "common/core/result.hpp"
#include "common/geometry/aabb.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cd {

/// What the six numbers of a line mean.
enum class LineForm : std::uint8_t {
    Ends, ///< The start and the end.
    Rays, ///< The start and a direction.
};

/// Reads the lines of an NPY file of shape (N, 6). The ends are taken literally. A ray is a line
/// that ends behind the box: start + 2^k direction, for a k that suffices, rounded once. Errors:
/// NotFound; Io; BadInput naming the file and the row for another shape, for numbers that are not
/// finite, for ends that are one point, and for a direction that is 0 or too short.
[[nodiscard]] Result<std::vector<LineEnds>>
read_lines(const std::filesystem::path& path, LineForm form, const Aabb& box);

} // namespace cd
