// Draws triangles orthographically, with a depth buffer and flat shading, without a library.
#pragma once

#include "client/picture/image.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace cd {

/// A view direction and an up vector, both nonzero and not parallel to each other.
struct Viewpoint {
    Vec3 towards_eye; ///< Direction in world coordinates, of any length.
    Vec3 up = {0, 0, 1};
};

/// Rasterises a picture. It uses only + - * / and sqrt of doubles in a fixed order, so pixels are
/// identical on every host.
class Rasteriser {
  public:
    /// Makes a picture of width x height pixels that shows all of `scene`, a box in world
    /// coordinates. Each pixel is the mean of `samples` x `samples` points.
    Rasteriser(
        unsigned width, unsigned height, unsigned samples, const Viewpoint& eye, const Aabb& scene);

    /// Draws both sides of a triangle in world coordinates, shaded by its angle to the light.
    void draw(const Corners& world, Colour colour);
    /// Marks a triangle: in full where it is in sight, and faintly where it is hidden.
    void mark(const Corners& world, Colour colour);
    /// Marks a line, two pixels wide.
    void mark_line(const Vec3& from, const Vec3& to, Colour colour);

    /// Hides the marks made so far behind triangles, whose vertices are in world coordinates, as
    /// `draw` does, but without drawing the triangles.
    void hide(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

    /// Returns the number of sample points that show a mark in full.
    [[nodiscard]] std::size_t marks_in_sight() const;
    [[nodiscard]] Image image() const;

  private:
    struct Layer {
        std::vector<float> depth; ///< Depth along `towards_eye`; the largest is in front.
        std::vector<Colour> colour;
    };
    using Point = std::array<double, 3>; ///< Samples from the left and from the top, and depth.
    /// A rectangle of samples; both ends belong to it.
    struct Region {
        double left = 0;
        double top = 0;
        double right = 0;
        double bottom = 0;
    };

    [[nodiscard]] Colour shaded(const Corners& world, Colour colour) const;
    [[nodiscard]] bool shows_mark(std::size_t sample) const;
    [[nodiscard]] static Region bounds_of(const std::array<Point, 3>& corners);
    [[nodiscard]] Point project(const Vec3& world) const;
    void mark(const std::array<Point, 3>& corners, Colour colour);
    [[nodiscard]] std::uint8_t sides_of_marks(const Point& point) const;
    void fill(const std::array<Point, 3>& corners,
              Colour colour,
              Layer& layer,
              const Region& region) const;

    unsigned samples_;
    unsigned width_;                            ///< Width in samples.
    unsigned height_;                           ///< Height in samples.
    std::array<std::array<double, 3>, 3> axes_; ///< Unit vectors right, up and towards the eye.
    double scale_ = 1;                          ///< Samples per unit of length.
    std::array<double, 2> center_{};            ///< Centre of the scene, along right and up.
    double depth_margin_ = 0; ///< A mark is hidden by what is farther in front of it.
    Region whole_;            ///< All samples.
    Region marks_;            ///< The samples around all marks; left > right if there are none.
    double deepest_mark_ = std::numeric_limits<double>::infinity(); ///< Least depth of all marks.
    Layer solid_;
    Layer marked_;
};

} // namespace cd
