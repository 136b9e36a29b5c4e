#include "client/picture/rasteriser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cd {

namespace {

constexpr double border = 0.04;    ///< Empty share of the picture around the scene.
constexpr double ambient = 0.35;   ///< Brightness of a face seen edge on.
constexpr double mark_faint = 0.4; ///< Strength of a hidden mark, 0 to 1.
constexpr Colour background{255, 255, 255};
constexpr float nothing = -std::numeric_limits<float>::infinity();

using Vector = std::array<double, 3>;

Vector vector_of(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector normalised(const Vector& v) {
    const double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

std::uint8_t channel(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);
}

Colour blended(Colour below, Colour above, double strength) {
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return channel((1 - strength) * a + strength * b);
    };
    return {mix(below.red, above.red), mix(below.green, above.green), mix(below.blue, above.blue)};
}

/// Returns twice the signed area of the triangle a, b, (x, y) in the plane of the picture.
double area2(const Vector& a, const Vector& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

} // namespace

Rasteriser::Rasteriser(
    unsigned width, unsigned height, unsigned samples, const Viewpoint& eye, const Aabb& scene)
    : samples_(samples), width_(width * samples), height_(height * samples) {
    axes_[2] = normalised(vector_of(eye.towards_eye));
    axes_[0] = normalised(cross(vector_of(eye.up), axes_[2]));
    axes_[1] = cross(axes_[2], axes_[0]);
    const Vector center = vector_of(scene.center());
    const Vector half = vector_of(0.5 * scene.size());
    std::array<double, 3> reach{}; // Half extents of the scene's box along the axes.
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            reach[i] += std::abs(axes_[i][k]) * half[k];
        }
    }
    const double across = std::max(reach[0], std::numeric_limits<double>::min());
    const double along = std::max(reach[1], std::numeric_limits<double>::min());
    scale_ = (0.5 - border) * std::min(width_ / across, height_ / along);
    center_ = {dot(axes_[0], center), dot(axes_[1], center)};
    depth_margin_ = 0.002 * (reach[0] + reach[1] + reach[2]);
    whole_ = {0, 0, width_ - 1.0, height_ - 1.0};
    marks_ = {width_ - 1.0, height_ - 1.0, 0, 0};
    const std::size_t count = std::size_t{width_} * height_;
    for (Layer* layer : {&solid_, &marked_}) {
        layer->depth.assign(count, nothing);
        layer->colour.assign(count, background);
    }
}

Rasteriser::Point Rasteriser::project(const Vec3& world) const {
    const Vector point = vector_of(world);
    return {0.5 * width_ + scale_ * (dot(axes_[0], point) - center_[0]),
            0.5 * height_ - scale_ * (dot(axes_[1], point) - center_[1]),
            dot(axes_[2], point)};
}

Colour Rasteriser::shaded(const Corners& world, Colour colour) const {
    const Vector normal = cross(vector_of(world[1] - world[0]), vector_of(world[2] - world[0]));
    const double length = std::sqrt(dot(normal, normal));
    // The light comes from the eye's direction, but somewhat more from above and from the left.
    Vector light{};
    for (std::size_t i = 0; i < 3; ++i) {
        light[i] = axes_[2][i] + 0.5 * axes_[1][i] - 0.4 * axes_[0][i];
    }
    light = normalised(light);
    const double facing = length > 0 ? std::abs(dot(normal, light)) / length : 1;
    return blended({0, 0, 0}, colour, ambient + (1 - ambient) * facing);
}

Rasteriser::Region Rasteriser::bounds_of(const std::array<Point, 3>& corners) {
    const auto& [a, b, c] = corners;
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
    return {left, top, right, bottom};
}

void Rasteriser::fill(const std::array<Point, 3>& corners,
                      Colour colour,
                      Layer& layer,
                      const Region& region) const {
    const auto& [a, b, c] = corners;
    const double area = area2(a, b, c[0], c[1]);
    if (!(area != 0)) {
        return; // The triangle is edge on, degenerate, or NaN.
    }
    const Region bounds = bounds_of(corners);
    const auto first = [](double edge, double least) {
        return std::max(least, std::ceil(edge - 0.5));
    };
    const auto last = [](double edge, double most) {
        return std::min(most, std::floor(edge - 0.5));
    };
    const double bottom = last(bounds.bottom, region.bottom);
    const double right = last(bounds.right, region.right);
    for (double row = first(bounds.top, region.top); row <= bottom; ++row) {
        for (double column = first(bounds.left, region.left); column <= right; ++column) {
            const double x = column + 0.5;
            const double y = row + 0.5;
            const double of_a = area2(b, c, x, y) / area;
            const double of_b = area2(c, a, x, y) / area;
            const double of_c = 1 - of_a - of_b;
            if (of_a < 0 || of_b < 0 || of_c < 0) {
                continue;
            }
            const auto depth = static_cast<float>(of_a * a[2] + of_b * b[2] + of_c * c[2]);
            const std::size_t sample =
                static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(column);
            if (depth > layer.depth[sample]) {
                layer.depth[sample] = depth;
                layer.colour[sample] = colour;
            }
        }
    }
}

void Rasteriser::draw(const Corners& world, Colour colour) {
    fill({project(world[0]), project(world[1]), project(world[2])},
         shaded(world, colour),
         solid_,
         whole_);
}

void Rasteriser::mark(const Corners& world, Colour colour) {
    mark({project(world[0]), project(world[1]), project(world[2])}, colour);
}

void Rasteriser::mark_line(const Vec3& from, const Vec3& to, Colour colour) {
    const Point a = project(from);
    const Point b = project(to);
    const double x = b[0] - a[0];
    const double y = b[1] - a[1];
    const double length = std::sqrt(x * x + y * y);
    if (!(length > 0)) {
        return; // The eye sees a point.
    }
    const double across = samples_ / length; // One pixel to each side.
    const auto beside = [&](const Point& point, double side) {
        return Point{point[0] - side * across * y, point[1] + side * across * x, point[2]};
    };
    mark({beside(a, -1), beside(a, 1), beside(b, 1)}, colour);
    mark({beside(a, -1), beside(b, 1), beside(b, -1)}, colour);
}

void Rasteriser::mark(const std::array<Point, 3>& corners, Colour colour) {
    fill(corners, colour, marked_, whole_);
    const Region bounds = bounds_of(corners);
    marks_.left = std::clamp(std::floor(bounds.left), 0.0, marks_.left);
    marks_.top = std::clamp(std::floor(bounds.top), 0.0, marks_.top);
    marks_.right = std::clamp(std::ceil(bounds.right), marks_.right, whole_.right);
    marks_.bottom = std::clamp(std::ceil(bounds.bottom), marks_.bottom, whole_.bottom);
    deepest_mark_ = std::min({deepest_mark_, corners[0][2], corners[1][2], corners[2][2]});
}

/// Returns a bit for each side of all marks on which a point is: left, right, above, below, behind.
std::uint8_t Rasteriser::sides_of_marks(const Point& point) const {
    return static_cast<std::uint8_t>(
        (point[0] < marks_.left ? 1 : 0) | (point[0] > marks_.right + 1 ? 2 : 0) |
        (point[1] < marks_.top ? 4 : 0) | (point[1] > marks_.bottom + 1 ? 8 : 0) |
        (point[2] < deepest_mark_ ? 16 : 0));
}

void Rasteriser::hide(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
    std::vector<Point> points(vertices.size());
    std::vector<std::uint8_t> sides(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        points[i] = project(vertices[i]);
        sides[i] = sides_of_marks(points[i]);
    }
    for (const auto& [a, b, c] : triangles) {
        // A triangle hides no mark if all its corners are on the same side of the marks.
        if ((sides[a] & sides[b] & sides[c]) == 0) {
            fill({points[a], points[b], points[c]}, background, solid_, marks_);
        }
    }
}

bool Rasteriser::shows_mark(std::size_t sample) const {
    return static_cast<double>(marked_.depth[sample]) + depth_margin_ >=
           static_cast<double>(solid_.depth[sample]);
}

std::size_t Rasteriser::marks_in_sight() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < marked_.depth.size(); ++i) {
        count += marked_.depth[i] != nothing && shows_mark(i) ? 1 : 0;
    }
    return count;
}

Image Rasteriser::image() const {
    Image image{width_ / samples_, height_ / samples_, {}};
    const double share = 1.0 / (samples_ * samples_);
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < image.width; ++x) {
            Vector sum{};
            for (std::size_t i = 0; i < std::size_t{samples_} * samples_; ++i) {
                const std::size_t sample =
                    (y * samples_ + i / samples_) * width_ + x * samples_ + i % samples_;
                Colour seen = solid_.colour[sample];
                if (marked_.depth[sample] != nothing) {
                    seen = blended(
                        seen, marked_.colour[sample], shows_mark(sample) ? 1.0 : mark_faint);
                }
                sum[0] += seen.red;
                sum[1] += seen.green;
                sum[2] += seen.blue;
            }
            image.pixels.push_back(
                {channel(sum[0] * share), channel(sum[1] * share), channel(sum[2] * share)});
        }
    }
    return image;
}

} // namespace cd
