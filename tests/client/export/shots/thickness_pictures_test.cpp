// Proves that a picture shows the thickness of each line where the line is.
#include "client/export/shots/thickness_pictures.hpp"

#include "tests/support/line_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cd::tests {

namespace {

constexpr Colour white{255, 255, 255};

std::shared_ptr<const ShotJob> job_of(const ExportContext& context) {
    return std::make_shared<const ShotJob>(context);
}

ThicknessPictures pictures_of(const LineScene& scene) {
    ThicknessPictures pictures(job_of(scene.context()));
    for (const ScenarioResult& result : scene.results(shots_query(Level::Pairs))) {
        EXPECT_TRUE(pictures.add(result));
    }
    pictures.finish();
    return pictures;
}

} // namespace

TEST(ThicknessPictures, ShowTheBodyInTheMiddle) {
    const LineScene scene;
    const ThicknessPictures pictures = pictures_of(scene);
    ASSERT_EQ(pictures.count(), 1u);
    EXPECT_EQ(pictures.largest(0), 1.5) << "both boxes";
    const Image image = pictures.image(0);
    ASSERT_EQ(image.width, 12u);
    ASSERT_EQ(image.height, 12u);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::size_t x = i % 12;
        const std::size_t y = i / 12;
        const bool is_inside = x >= 4 && x < 8 && y >= 4 && y < 8;
        EXPECT_EQ(image.pixels[i] == white, !is_inside) << x << ", " << y;
    }
}

TEST(ThicknessPictures, AreAsTheStartsOfLinesSeeTheBody) {
    LineScene scene;
    // A block at the left and the top of what lines from the front see: y is small, and z great.
    MeshArrays arrays;
    add_part(make_box_between(Vec3(0, 0, 0), Vec3(1, 1, 1)), "body", arrays);
    add_part(make_box_between(Vec3(2, 0, 0.75), Vec3(2.5, 0.25, 1)), "block", arrays);
    scene.a = share(Mesh::create(std::move(arrays)).value());
    scene.lines = share(shot_mesh(scene.spec, scene.box()).value());
    const Image image = pictures_of(scene).image(0);
    const auto darkest = std::ranges::min_element(image.pixels, {}, &Colour::red);
    const auto place = static_cast<std::size_t>(darkest - image.pixels.begin());
    EXPECT_EQ(std::ranges::count(image.pixels, *darkest), 1);
    EXPECT_EQ(place % image.width, 4u);
    EXPECT_EQ(place / image.width, 4u);
}

TEST(ThicknessPictures, HaveAPixelForSomeLinesWhereThereAreMany) {
    LineScene scene;
    scene.spec.grid.spacing = 1.0 / 512;
    scene.spec.grid.tile = 512;
    const ThicknessPictures pictures(job_of(scene.context()));
    const Image image = pictures.image(0);
    EXPECT_LE(image.width, ThicknessBounds().side);
    EXPECT_GT(image.width, ThicknessBounds().side / 2);
    const ThicknessPictures large(job_of(scene.context()), large_thickness);
    EXPECT_GT(large.image(0).width, image.width);
    EXPECT_LE(large.image(0).width, large_thickness.side);
    EXPECT_EQ(pictures.largest(0), 0);
}

TEST(ThicknessPictures, NoneAreOfLinesOfAFile) {
    ExportContext context = LineScene().context();
    context.bodies[1].views = nullptr;
    const ThicknessPictures pictures(job_of(context));
    EXPECT_EQ(pictures.count(), 0u);
}

} // namespace cd::tests
