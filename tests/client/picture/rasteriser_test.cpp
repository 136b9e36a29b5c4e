// Proves the content of pictures: the whole scene, occlusion, lit faces, marks; equal pixels on
// every host; and that a PNG file holds them.
#include "client/picture/rasteriser.hpp"

#include "client/picture/body_picture.hpp"
#include "common/core/files/hash.hpp"
#include "tests/support/near_results.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {
namespace {

constexpr Colour grey{200, 200, 200};
constexpr Colour red{255, 0, 0};
const Viewpoint from_above{{0, 0, 1}, {0, 1, 0}};

/// Makes a square with corners (+-1, +-1, z) of two triangles.
std::array<Corners, 2> square(double z, double size = 1) {
    const Vec3 a(-size, -size, z);
    const Vec3 b(size, -size, z);
    const Vec3 c(size, size, z);
    const Vec3 d(-size, size, z);
    return {{{a, b, c}, {a, c, d}}};
}

Rasteriser small_picture(const Viewpoint& eye = from_above) {
    Aabb scene;
    scene.add({-1, -1, -1});
    scene.add({1, 1, 1});
    return {16, 16, 1, eye, scene};
}

/// Prints a letter per pixel: '.' is background; later letters are darker.
std::string text_of(const Image& image) {
    std::string text;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Colour pixel = image.pixels[i];
        const int sum = pixel.red + pixel.green + pixel.blue;
        text += sum == 3 * 255 ? '.' : static_cast<char>('a' + (3 * 255 - sum) / 64);
        text += (i + 1) % image.width == 0 ? "\n" : "";
    }
    return text;
}

Colour at(const Image& image, unsigned x, unsigned y) {
    return image.pixels[std::size_t{y} * image.width + x];
}

TEST(Rasteriser, AllOfTheSceneIsInThePictureWithABorder) {
    Rasteriser picture = small_picture();
    for (const Corners& triangle : square(0)) {
        picture.draw(triangle, grey);
    }
    const Image image = picture.image();
    ASSERT_EQ(image.pixels.size(), 256u);
    for (unsigned i = 0; i < 16; ++i) {
        EXPECT_EQ(at(image, i, 0), (Colour{255, 255, 255}));
        EXPECT_EQ(at(image, 0, i), (Colour{255, 255, 255}));
    }
    for (unsigned y = 1; y < 15; ++y) {
        for (unsigned x = 1; x < 15; ++x) {
            EXPECT_NE(at(image, x, y), (Colour{255, 255, 255})) << x << " " << y;
        }
    }
}

TEST(Rasteriser, WhatIsInFrontIsSeenWhateverTheOrder) {
    for (const bool front_first : {true, false}) {
        Rasteriser picture = small_picture();
        for (const int turn : {0, 1}) {
            const bool is_front = (turn == 0) == front_first;
            for (const Corners& triangle : square(is_front ? 0.5 : -0.5, is_front ? 0.5 : 1)) {
                picture.draw(triangle, is_front ? red : grey);
            }
        }
        const Image image = picture.image();
        EXPECT_EQ(at(image, 8, 8).green, 0);
        EXPECT_GT(at(image, 8, 8).red, 100);
        EXPECT_GT(at(image, 2, 8).green, 100);
    }
}

TEST(Rasteriser, ABoxShowsThreeFacesOfDifferentBrightness) {
    Rasteriser picture = small_picture({{1, -1, 1}});
    const Mesh box = make_box({1.2, 1.2, 1.2});
    for (std::uint32_t i = 0; i < box.triangles().size(); ++i) {
        picture.draw(box.corners(i), grey);
    }
    EXPECT_EQ(text_of(picture.image()),
              "................\n"
              "................\n"
              "................\n"
              "................\n"
              "......dddd......\n"
              ".....dddddd.....\n"
              "....fddddddi....\n"
              "....fffddiii....\n"
              "....ffffiiii....\n"
              "....ffffiiii....\n"
              ".....fffiii.....\n"
              "......ffii......\n"
              "................\n"
              "................\n"
              "................\n"
              "................\n");
}

TEST(Rasteriser, AMarkIsFullInFrontAndFaintBehind) {
    Rasteriser picture = small_picture();
    for (const Corners& triangle : square(0)) {
        picture.draw(triangle, grey);
    }
    picture.mark({Vec3(-0.9, -0.9, 0), Vec3(-0.1, -0.9, 0), Vec3(-0.9, -0.1, 0)}, red);
    picture.mark({Vec3(0.9, 0.9, -1), Vec3(0.1, 0.9, -1), Vec3(0.9, 0.1, -1)}, red);
    const Image image = picture.image();
    EXPECT_EQ(at(image, 2, 13), red);
    const Colour behind = at(image, 13, 2);
    EXPECT_GT(behind.red, behind.green);
    EXPECT_GT(behind.green, 50);
    EXPECT_GT(picture.marks_in_sight(), 3u);
    EXPECT_LT(picture.marks_in_sight(), 30u);
}

TEST(Rasteriser, HidingLeavesTheSameMarksInSightAsDrawing) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(-1.3, 1.3);
    const auto triangle = [&](double size) {
        const Vec3 at(anywhere(random), anywhere(random), anywhere(random));
        const auto near = [&] {
            return Vec3(at + size * Vec3(anywhere(random), anywhere(random), anywhere(random)));
        };
        return Corners{near(), near(), near()};
    };
    const std::array<Triangle, 1> corners{{{0, 1, 2}}};
    std::size_t hidden = 0;
    for (int round = 0; round < 400; ++round) {
        Rasteriser drawn = small_picture({{0.3, -1, 0.5}});
        Rasteriser only_marks = drawn;
        for (int i = 0; i < 1 + round % 4; ++i) {
            const Corners mark = triangle(0.3);
            drawn.mark(mark, red);
            only_marks.mark(mark, red);
        }
        const std::size_t before = only_marks.marks_in_sight();
        for (int i = 0; i < 20; ++i) {
            const Corners solid = triangle(0.5);
            drawn.draw(solid, grey);
            only_marks.hide(solid, corners);
        }
        ASSERT_EQ(only_marks.marks_in_sight(), drawn.marks_in_sight()) << "round " << round;
        hidden += before - drawn.marks_in_sight();
    }
    EXPECT_GT(hidden, 100u);
}

TEST(Rasteriser, DegenerateTrianglesAndPointsOutsideAreHarmless) {
    Rasteriser picture = small_picture();
    const Vec3 point(0.1, 0.2, 0.3);
    picture.draw({point, point, point}, grey);
    picture.draw({point, Vec3(0.5, 0.5, 0.5), point}, grey);
    picture.draw({Vec3(-1e9, 5, 0), Vec3(1e9, 5, 0), Vec3(0, 6, 0)}, grey);
    for (const Colour& pixel : picture.image().pixels) {
        EXPECT_EQ(pixel, (Colour{255, 255, 255}));
    }
}

TEST(BodyPicture, TheSamePixelsEverywhere) {
    const Mesh torus = make_torus(1, 0.3, 40, 20);
    const Mesh sphere = make_sphere(3);
    const std::vector<PicturedBody> bodies{
        {&torus, Pose{}, {150, 170, 200}, {1, 2, 3, 40}},
        {&sphere, translation_pose(1.5, 0.25, 0), {225, 190, 120}, {5, 6}}};
    const Image image = draw_contacts(bodies, {120, 75});
    const std::span<const Colour> pixels(image.pixels);
    EXPECT_EQ(to_hex(sha256(std::as_bytes(pixels))).substr(0, 16), "29a4ffd3a53070bd");
}

TEST(BodyPicture, NearTrianglesAndLinesHaveColoursOfTheirOwn) {
    const Mesh box = make_box({1, 1, 1});
    const auto count = [](const Image& image, const Colour& colour) {
        return std::ranges::count(image.pixels, colour);
    };
    const std::vector<ContactPair> pairs{
        {0, 4, PairClass::Near}, {1, 4, PairClass::Proper}, {1, 5, PairClass::Near}};
    const auto bodies = pictured(box, box, {Pose{}, translation_pose(1.5, 0, 0)}, pairs);
    EXPECT_EQ(bodies[0].contacts, std::vector<std::uint32_t>{1});
    EXPECT_EQ(bodies[0].near, std::vector<std::uint32_t>{0}) << "1 is in contact, which is worse";
    EXPECT_EQ(bodies[1].near, std::vector<std::uint32_t>{5});
    const Image plain = draw_contacts(bodies, {120, 75});
    EXPECT_GT(count(plain, near_colour), 0);
    EXPECT_EQ(count(plain, gap_colour), 0);
    // The view is along x, between the boxes.
    const std::vector<GapLine> lines{{Vec3(0.75, -0.5, -0.7), Vec3(0.75, 0.5, 0.7)},
                                     {Vec3(0.5, 0, 0.6), Vec3(0.5, 0, 0.6)}};
    EXPECT_GT(count(draw_contacts(bodies, {120, 75}, lines), gap_colour), 0);
}

TEST(BodyPicture, LinesJoinTheNearestPointsOfNearPairs) {
    const auto results = near_results(Level::Contacts);
    EXPECT_TRUE(gap_lines(results[0]).empty());
    const std::vector<GapLine> lines = gap_lines(results[2]);
    ASSERT_EQ(lines.size(), 1u) << "of the near pair, not of the touching one";
    EXPECT_EQ(lines[0][1], Vec3(0, 0.0625, 0));
    EXPECT_EQ(gap_lines(results[1])[1][1], Vec3(20.25, 0, 0)) << "in the world";
    EXPECT_TRUE(gap_lines(near_results(Level::Pairs)[1]).empty());
}

/// Two rods, one behind the other along an axis. All their triangles are marked, so that most is
/// seen from an end, where they fill the picture.
struct TwoRods {
    explicit TwoRods(int axis, PairClass first) : along(Vec3::Unit(axis)) {
        Vec3 size = Vec3::Ones();
        size[axis] = 8;
        mesh = make_box(size);
        const Vec3 move = 8.125 * along;
        for (std::uint32_t i = 0; i < 12; ++i) {
            pairs.push_back({i, i, i == 0 ? first : PairClass::Near});
        }
        bodies =
            pictured(mesh, mesh, {Pose{}, translation_pose(move.x(), move.y(), move.z())}, pairs);
        lines = {{Vec3(-along), Vec3(9 * along)}, {Vec3(4 * along), Vec3(4.125 * along)}};
    }

    /// The cosine of the angle between the view and the axis.
    [[nodiscard]] double cosine(std::span<const GapLine> of) const {
        const Vec3 eye = viewpoint_of(bodies, of).towards_eye;
        return std::abs(eye.dot(along)) / eye.norm();
    }

    Vec3 along;
    Mesh mesh = make_box({1, 1, 1});
    std::vector<ContactPair> pairs;
    std::vector<PicturedBody> bodies;
    std::vector<GapLine> lines;
};

TEST(BodyPicture, AGapIsSeenFromItsSide) {
    for (int axis = 0; axis < 3; ++axis) {
        const TwoRods rods(axis, PairClass::Near);
        EXPECT_LE(rods.cosine(rods.lines), std::sqrt(0.5) + 1e-6) << "at least 45 degrees";
        EXPECT_GT(rods.cosine({}), 0.99) << "most is seen from where the gap is not";
    }
}

TEST(BodyPicture, ContactsAreLookedForWhateverIsNear) {
    const TwoRods rods(2, PairClass::Touch);
    EXPECT_EQ(rods.cosine(rods.lines), rods.cosine({}));
    EXPECT_NE(rods.cosine({}), TwoRods(2, PairClass::Near).cosine(rods.lines));
}

TEST(BodyPicture, PartsHaveColoursOfTheirOwn) {
    MeshArrays arrays;
    for (const auto& triangles : {square(0), square(1)}) {
        for (const Corners& corners : triangles) {
            const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
            arrays.vertices.insert(arrays.vertices.end(), corners.begin(), corners.end());
            arrays.triangles.push_back({first, first + 1, first + 2});
        }
    }
    arrays.parts = {{"floor", 0, 2}, {"roof", 2, 4}};
    const Image image = draw_parts(Mesh::create(std::move(arrays)).value(), {60, 40});
    std::set<std::array<int, 3>> colours;
    for (const Colour& pixel : image.pixels) {
        colours.insert({pixel.red, pixel.green, pixel.blue});
    }
    EXPECT_GE(colours.size(), 3u);
}

TEST(Png, AFileHoldsThePixels) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "p.png";
    const Image image{2, 2, {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {255, 0, 128}}};
    ASSERT_TRUE(write_png(image, path));
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&header, path.c_str()), 0) << header.message;
    header.format = PNG_FORMAT_RGB;
    ASSERT_EQ(header.width, 2u);
    std::vector<Colour> read(4);
    ASSERT_NE(png_image_finish_read(&header, nullptr, read.data(), 0, nullptr), 0);
    EXPECT_EQ(read, image.pixels);
}

TEST(Png, AFolderThatIsNotThereIsNamed) {
    const Status written = write_png({1, 1, {{}}}, "/no/such/folder/p.png");
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().detail.find("/no/such/folder"), std::string::npos);
}

} // namespace
} // namespace cd::tests
