#include "client/bundle/line_file.hpp"

#include "client/formats/npy.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace cd {

namespace {

constexpr std::size_t numbers_of_line = 6;
constexpr std::uint64_t rows_at_once = 4096;

/// Returns the distance from a point to the farthest corner of a box, or more.
double farthest(const Vec3& from, const Aabb& box) {
    const Vec3 apart = (from - box.min).cwiseAbs().cwiseMax((from - box.max).cwiseAbs());
    return 1.001 * apart.stableNorm();
}

/// Returns the end of a ray that is at least `length` long. The product with a power of two is
/// exact, so each coordinate is rounded once.
Result<Vec3> end_of_ray(const Vec3& start, const Vec3& direction, double length) {
    const double norm = direction.stableNorm();
    if (!(norm > 0)) {
        return bad_input("a direction of length 0");
    }
    const double share = length / norm;
    if (!std::isfinite(share)) {
        return bad_input("a direction that is too short");
    }
    int exponent = 0;
    std::frexp(share, &exponent);
    const double factor = std::ldexp(1.0, exponent);
    const Vec3 end = start + factor * direction;
    if (!end.allFinite()) {
        return bad_input("a ray whose end is too far away");
    }
    return end;
}

Result<LineEnds> line_of(std::span<const double> numbers, LineForm form, const Aabb& box) {
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) {
        return bad_input("a number that is not finite");
    }
    const Vec3 start(numbers[0], numbers[1], numbers[2]);
    const Vec3 second(numbers[3], numbers[4], numbers[5]);
    if (form == LineForm::Ends) {
        if (start == second) {
            return bad_input("a line without a direction: its ends are one point");
        }
        return LineEnds{start, second};
    }
    const Vec3 end = CD_TRY(end_of_ray(start, second, farthest(start, box)));
    return LineEnds{start, end};
}

} // namespace

Result<std::vector<LineEnds>>
read_lines(const std::filesystem::path& path, LineForm form, const Aabb& box) {
    if (path.extension() != ".npy") {
        return bad_input(path, "lines come from an .npy file of shape (N, 6)");
    }
    const auto rows = CD_TRY(NpyRows::open(path));
    if (rows->shape().size() != 2 || rows->row_size() != numbers_of_line) {
        return bad_input(path,
                         fmt::format("an array of shape ({}); lines need (N, 6)",
                                     fmt::join(rows->shape(), ", ")));
    }
    if (rows->row_count() == 0 || rows->row_count() > limits::mesh_triangles_max / 2) {
        return bad_input(path,
                         fmt::format("{} lines; a file has 1 to {}",
                                     rows->row_count(),
                                     limits::mesh_triangles_max / 2));
    }
    std::vector<LineEnds> lines;
    for (std::uint64_t first = 0; first < rows->row_count(); first += rows_at_once) {
        const std::uint64_t count = std::min(rows_at_once, rows->row_count() - first);
        const std::vector<double> numbers = CD_TRY(rows->read(first, count));
        for (std::uint64_t i = 0; i < count; ++i) {
            const auto row = std::span(numbers).subspan(numbers_of_line * i, numbers_of_line);
            lines.push_back(CD_TRY(within(fmt::format("{}: row {}: ", path.string(), first + i),
                                          line_of(row, form, box))));
        }
    }
    return lines;
}

} // namespace cd
