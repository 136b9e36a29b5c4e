// Draws triangles into an image: orthographic, with a depth buffer, flat shading and no library.
#pragma once

#include "client/picture/image.hpp"
#include "common/geometry/aabb.hpp"
#include "common/geometry/types.hpp"

#include <array>
#include <vector>

namespace cd {

/// From where a scene is seen. Neither vector is zero, and they are not parallel.
struct Viewpoint {
    Vec3 towards_eye; ///< In world coordinates; need not have length 1.
    Vec3 up = {0, 0, 1};
};

/// A picture in the making. Uses + - * / and sqrt of doubles in a fixed order, so that all hosts
/// make the same pixels.
class Rasteriser {
  public:
    /// A picture of width x height pixels that shows all of `scene`, a box in world coordinates.
    /// `samples` squared points of each pixel are looked at and averaged.
    Rasteriser(
        unsigned width, unsigned height, unsigned samples, const Viewpoint& eye, const Aabb& scene);

    /// Draws a triangle in world coordinates, shaded by the angle at which it is seen. Both sides
    /// show.
    void draw(const Corners& world, Colour colour);
    /// Marks a triangle: it shows in full where nothing is in front of it, and faintly elsewhere.
    void mark(const Corners& world, Colour colour);

    /// How many sample points show a mark in full.
    [[nodiscard]] std::size_t marks_in_sight() const;
    [[nodiscard]] Image image() const;

  private:
    struct Layer {
        std::vector<float> depth; ///< Along `towards_eye`: the largest is in front.
        std::vector<Colour> colour;
    };
    using Point = std::array<double, 3>; ///< In samples from the left and the top, and the depth.

    [[nodiscard]] Point project(const Vec3& world) const;
    [[nodiscard]] Colour shaded(const Corners& world, Colour colour) const;
    [[nodiscard]] bool shows_mark(std::size_t sample) const;
    void fill(const std::array<Point, 3>& corners, Colour colour, Layer& layer) const;

    unsigned samples_;
    unsigned width_;                            ///< In samples.
    unsigned height_;                           ///< In samples.
    std::array<std::array<double, 3>, 3> axes_; ///< Right, up and towards the eye; of length 1.
    double scale_ = 1;                          ///< Samples a unit of length.
    std::array<double, 2> center_{};            ///< Of the scene, along right and up.
    double depth_margin_ = 0; ///< A mark shows unless something is in front of it by more.
    Layer solid_;
    Layer marked_;
};

} // namespace cd
