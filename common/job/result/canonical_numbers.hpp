// Numbers in records, each in its one canonical bit pattern.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"
#include "common/geometry/types.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace cd {

/// Returns the number in a canonical bit pattern: zero has no sign, and NaN (a point that left the
/// range of double) has no payload.
[[nodiscard]] double canonical(double value);
[[nodiscard]] bool is_canonical(double value);

void put_numbers(ByteWriter& out, std::span<const double> numbers);
void put_points(ByteWriter& out, std::span<const Vec3> points);

/// Reads `count` points into `points`. Errors: BadFrame.
[[nodiscard]] Status get_points(ByteReader& in, std::size_t count, std::vector<Vec3>& points);

/// Returns whether a number may be a distance in a record: finite, at least 0, and canonical.
/// Distances below half the least denormal number round to 0.
[[nodiscard]] bool is_distance(double value);

} // namespace cd
