#include "client/demo/sheet.hpp"

#include "common/core/check.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cd {

namespace {

struct Cells {
    std::uint32_t u = 1;
    std::uint32_t v = 1;
};

/// Returns the sheet's grid for so many triangles, or nothing if its shape needs more.
std::optional<Cells> cells_of(const Sheet& sheet, double triangles) {
    const std::uint32_t least_u = sheet.closed_u ? 4 : 1;
    const std::uint32_t least_v = sheet.closed_v ? 4 : 1;
    const double quads = 0.5 * triangles;
    if (quads < 0.7 * least_u * least_v) {
        return std::nullopt;
    }
    const auto whole = [](double x, std::uint32_t least) {
        return std::max(least, static_cast<std::uint32_t>(x + 0.5));
    };
    Cells cells;
    cells.u = whole(std::sqrt(quads * sheet.cells_u_per_v), least_u);
    cells.v = whole(quads / cells.u, least_v);
    cells.u = whole(quads / cells.v, least_u);
    return cells;
}

double rounded(double x) {
    return static_cast<float>(x);
}

void add_sheet(const Sheet& sheet, const Cells& cells, MeshArrays& arrays) {
    const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
    const std::uint32_t lines_u = sheet.closed_u ? cells.u : cells.u + 1;
    const std::uint32_t lines_v = sheet.closed_v ? cells.v : cells.v + 1;
    for (std::uint32_t i = 0; i < lines_u; ++i) {
        for (std::uint32_t j = 0; j < lines_v; ++j) {
            const Vec3 p =
                sheet.at(static_cast<double>(i) / cells.u, static_cast<double>(j) / cells.v);
            arrays.vertices.emplace_back(rounded(p.x()), rounded(p.y()), rounded(p.z()));
        }
    }
    const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
        return first + (i % lines_u) * lines_v + j % lines_v;
    };
    for (std::uint32_t i = 0; i < cells.u; ++i) {
        for (std::uint32_t j = 0; j < cells.v; ++j) {
            const Triangle quad{vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)};
            arrays.triangles.push_back(quad);
            arrays.triangles.push_back({quad[0], quad[2], vertex(i, j + 1)});
        }
    }
}

} // namespace

CirclePoint circle_point(double turn) {
    const double quarters = 4 * (turn - std::floor(turn));
    const int quarter = std::min(3, static_cast<int>(quarters));
    const double part = quarters - quarter;
    // Approximates the tangent of half the angle within the quarter.
    const double t = part * (0.785 + 0.215 * part * part);
    const double c = (1 - t * t) / (1 + t * t);
    const double s = 2 * t / (1 + t * t);
    switch (quarter) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

CirclePoint boxy_point(double turn) {
    const auto [c, s] = circle_point(turn);
    const double size = std::sqrt(std::sqrt(c * c * c * c + s * s * s * s));
    return {c / size, s / size};
}

double saw(double x) {
    const double part = x - std::floor(x);
    return part < 0.5 ? 2 * part : 2 - 2 * part;
}

std::shared_ptr<const Mesh> join_sheets(std::span<const Sheet> sheets, std::uint64_t triangles) {
    double shares = 0;
    for (const Sheet& sheet : sheets) {
        shares += sheet.share;
    }
    MeshArrays arrays;
    arrays.precision = Precision::Float;
    for (const Sheet& sheet : sheets) {
        const double own = static_cast<double>(triangles) * sheet.share / shares;
        if (const auto cells = cells_of(sheet, own)) {
            const auto begin = static_cast<std::uint32_t>(arrays.triangles.size());
            add_sheet(sheet, *cells, arrays);
            if (arrays.parts.empty() || arrays.parts.back().name != sheet.part) {
                arrays.parts.push_back({sheet.part, begin, begin});
            }
            arrays.parts.back().triangles_end = static_cast<std::uint32_t>(arrays.triangles.size());
        }
    }
    auto mesh = Mesh::create(std::move(arrays));
    CD_CHECK(mesh.has_value());
    return std::make_shared<const Mesh>(std::move(mesh.value()));
}

Surface tube(TubeShape shape) {
    CD_CHECK(shape.path.size() >= 2);
    return [shape = std::move(shape)](double u, double v) {
        const double along = v * static_cast<double>(shape.path.size() - 1);
        const auto piece = std::min(static_cast<std::size_t>(along), shape.path.size() - 2);
        const Vec3 step = shape.path[piece + 1] - shape.path[piece];
        const Vec3 side = step.cross(shape.up).normalized();
        const Vec3 high = side.cross(step).normalized();
        const auto [c, s] = shape.boxy ? boxy_point(u) : circle_point(u);
        const Vec3 middle = shape.path[piece] + (along - static_cast<double>(piece)) * step;
        return Vec3(middle + c * shape.wide * side + s * shape.high * high);
    };
}

} // namespace cd
