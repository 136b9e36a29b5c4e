#include "tests/corpus/scene_list.hpp"
#include "tests/corpus/solids.hpp"
#include "tests/support/shapes.hpp"

#include <string>
#include <utility>

namespace cd::tests {

namespace {

void add_open(Scenes& scenes) {
    const Mesh box = make_box_between(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    const Body open = surface(without_last(box, 2));
    const Mesh sphere = make_sphere(2);
    const auto add = [&](const char* name, const Body& a, Body b, const PosePair& poses) {
        scenes.push_back({name, "open bodies", a, std::move(b), poses});
    };
    add("a box inside an open box", open, solid(scaled(box, 0.5)), {});
    add("open boxes, stacked", open, open, {Pose{}, translation_pose(0, 0, 2)});
    add("open boxes, crossing", open, open, {Pose{}, translation_pose(0.5, 0.25, 0.125)});
    add("an open sphere on the whole one",
        surface(without_last(sphere, 5)),
        solid(Mesh(sphere)),
        {});
    add("an open sphere in a box", surface(without_last(sphere, 1)), solid(scaled(box, 2)), {});
}

/// Adds stacked boxes and soups with coordinates multiplied by `factor`.
void add_scaled(Scenes& scenes, const char* name, double factor) {
    const Body box =
        solid(scaled(make_ticked_box(ticks(0, 1, 3), ticks(0, 1, 3), ticks(0, 1, 3)), factor));
    std::mt19937_64 random(51);
    const Body soup = surface(scaled(make_triangle_soup(random, 60), factor));
    const Pose turned = make_pose(random, 0);
    const std::string word = name;
    const auto add = [&](const std::string& what, const Body& body, const PosePair& poses) {
        scenes.push_back({word + what, "extreme magnitudes", body, body, poses});
    };
    const double side = 3 * factor;
    add(" boxes, stacked", box, {Pose{}, translation_pose(0, 0, side)});
    add(" boxes, crossing", box, {Pose{}, translation_pose(factor, factor, factor)});
    add(" soup, turned", soup, {Pose{}, turned});
}

void add_soups(Scenes& scenes) {
    std::mt19937_64 random(53);
    for (int round = 0; round < 4; ++round) {
        const std::string number = std::to_string(round);
        const Body a = surface(make_triangle_soup(random, 150));
        const Body b = surface(make_triangle_soup(random, 150, 0.2));
        const PosePair poses{make_pose(random, 0.5), make_matrix_pose(random, 0.5)};
        scenes.push_back({"soup " + number, "soups", a, b, poses});
        const Body flawed = surface(make_degenerate_soup(random, 80));
        const Body other = surface(make_degenerate_soup(random, 80));
        scenes.push_back({"degenerate soup " + number, "soups", flawed, other, {}});
        scenes.push_back({"degenerate soup " + number + ", posed",
                          "soups",
                          flawed,
                          other,
                          {make_pose(random, 1), make_pose(random, 1)}});
    }
}

void add_scales(Scenes& scenes) {
    const Body large = solid(scaled(make_sphere(3), 1e6));
    const Body small = solid(scaled(make_sphere(1), 1e-6));
    const auto add = [&](const char* name, const Pose& pose) {
        scenes.push_back({name, "scales 1e-6 with 1e6", large, small, {Pose{}, pose}});
    };
    add("a sphere of 1e-6 around a corner of one of 1e6", translation_pose(1e6, 0, 0));
    add("a sphere of 1e-6 on a corner of one of 1e6", translation_pose(1e6 + 1e-6, 0, 0));
    add("a sphere of 1e-6 in the middle of one of 1e6", translation_pose(0.1, 0.2, 0.3));
    add("a sphere of 1e-6 beside one of 1e6", translation_pose(1e6 + 2e-6, 0, 0));
}

} // namespace

void add_odd_scenes(Scenes& scenes) {
    add_open(scenes);
    add_scales(scenes);
    add_soups(scenes);
    add_scaled(scenes, "tiny", 1e-20);
    add_scaled(scenes, "denormal", 0x1p-1070);
    add_scaled(scenes, "huge", 0x1p400);
}

} // namespace cd::tests
