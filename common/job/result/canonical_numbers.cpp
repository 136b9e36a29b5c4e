#include "common/job/result/canonical_numbers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cd {

double canonical(double value) {
    return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
}

bool is_canonical(double value) {
    return std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(canonical(value));
}

void put_numbers(ByteWriter& out, std::span<const double> numbers) {
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const double number : numbers) {
        values.push_back(canonical(number));
    }
    out.put_array(std::span<const double>(values));
}

void put_points(ByteWriter& out, std::span<const Vec3> points) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    put_numbers(out, {points.empty() ? nullptr : points.front().data(), 3 * points.size()});
}

Status get_points(ByteReader& in, std::size_t count, std::vector<Vec3>& points) {
    const auto values = in.get_array<double>(3 * count);
    if (in.failed()) {
        return Error{ErrorCode::BadFrame, "result record: points cut short"};
    }
    if (!std::all_of(values.begin(), values.end(), is_canonical)) {
        return Error{ErrorCode::BadFrame, "result record: a number that is not in canonical form"};
    }
    points.reserve(count);
    for (std::size_t i = 0; i < values.size(); i += 3) {
        points.emplace_back(values[i], values[i + 1], values[i + 2]);
    }
    return Done{};
}

bool is_distance(double value) {
    return value >= 0 && !std::isinf(value) && is_canonical(value);
}

} // namespace cd
