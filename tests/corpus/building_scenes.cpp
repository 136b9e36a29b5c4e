#include "tests/corpus/scene_list.hpp"
#include "tests/corpus/solids.hpp"
#include "tests/support/shapes.hpp"

#include <utility>

namespace cd::tests {

namespace {

void add_terrain(Scenes& scenes) {
    const Mesh ground = make_terrain(3, 12, 0.5, Vec3(0, 0, 0));
    const Mesh mapped = make_terrain(3, 12, 0.5, Vec3(691604.123, 5334712.456, 519.1));
    const auto add = [&](const char* name, const Mesh& a, Mesh b, const PosePair& poses) {
        scenes.push_back({name, "terrain", surface(Mesh(a)), surface(std::move(b)), poses});
    };
    add("terrain on itself", ground, Mesh(ground), {});
    add("terrain lifted by 1e-9", ground, translated(ground, Vec3(0, 0, 1e-9)), {});
    add("terrain lifted by 1e-9 by its pose",
        ground,
        Mesh(ground),
        {Pose{}, translation_pose(0, 0, 1e-9)});
    add("terrain in UTM coordinates on itself", mapped, Mesh(mapped), {});
    add("terrain in UTM coordinates lifted by 1e-9",
        mapped,
        Mesh(mapped),
        {Pose{}, translation_pose(0, 0, 1e-9)});
    add("terrain shifted by a cell", ground, Mesh(ground), {Pose{}, translation_pose(0.5, 0, 0)});
    add("terrain over other terrain", ground, make_terrain(4, 12, 0.5, Vec3(0, 0, 0)), {});
    add("terrain tiles, edge on edge", ground, Mesh(ground), {Pose{}, translation_pose(6, 0, 0)});
    scenes.push_back({"a box on terrain",
                      "terrain",
                      surface(make_terrain(5, 12, 0.5, Vec3(0, 0, 0))),
                      solid(make_box_between(Vec3(1, 1, 0.5), Vec3(3, 3, 2))),
                      {}});
}

void add_walls(Scenes& scenes) {
    const Body wall = solid(make_ticked_box(ticks(0, 0.5, 8), {0, 1e-6}, ticks(0, 0.5, 4)));
    const Body thick = solid(make_box_between(Vec3(0, 0, 0), Vec3(4, 0.25, 2)));
    const auto add = [&](const char* name, const Body& a, const Body& b, const PosePair& poses) {
        scenes.push_back({name, "thin walls", a, b, poses});
    };
    const auto at = [](double x, double y, double z) {
        return PosePair{Pose{}, translation_pose(x, y, z)};
    };
    add("thin walls, 1e-9 apart", wall, wall, at(0, 1e-6 + 1e-9, 0));
    add("thin walls, back to back", wall, wall, at(0, 1e-6, 0));
    add("thin walls, half into each other", wall, wall, at(0, 0.5e-6, 0));
    add("thin walls, shifted along", wall, wall, at(0.25, 0, 0));
    add("thin walls, end to end", wall, wall, at(4, 0, 0));
    add("thin walls, crossing",
        wall,
        wall,
        {Pose{}, Pose::from_quaternion({1, 0, 0, 1}, Vec3(2, -2, 0))});
    add("thin walls, T",
        wall,
        wall,
        {Pose{}, Pose::from_quaternion({1, 0, 0, 1}, Vec3(2, 1e-6, 0))});
    add("a thin wall within a thick one", thick, wall, at(0, 0.125, 0));
    add("a thin wall on a thick one", thick, wall, at(0, 0.25, 0));
    add("thin walls, crossing, both posed",
        wall,
        wall,
        {Pose::from_quaternion({3, 1, 0, 2}, Vec3(1, 2, 3)),
         Pose::from_quaternion({3, 1, 0, 2.0000001}, Vec3(1, 2, 3))});
}

/// Makes a building with millimetre coordinates at this UTM position.
Mesh building(double east, double north, const std::vector<Vec2>& outline, double height) {
    std::vector<Vec2> placed;
    for (const Vec2& corner : outline) {
        placed.push_back({east + corner[0], north + corner[1]});
    }
    return make_prism(placed, 519.1, 519.1 + height);
}

void add_buildings(Scenes& scenes) {
    const double east = 691604.123;
    const double north = 5334712.456;
    const std::vector<Vec2> house{{0, 0}, {12.34, 0}, {12.34, 8.765}, {0, 8.765}};
    const std::vector<Vec2> turned{{0, 0}, {7.071, 7.071}, {3.536, 10.607}, {-3.536, 3.536}};
    const std::vector<Vec2> ell{{0, 0}, {9.1, 0}, {9.1, 4.2}, {4.4, 4.2}, {4.4, 8.8}, {0, 8.8}};
    const auto add = [&](const char* name, Mesh a, Mesh b, const PosePair& poses) {
        scenes.push_back({name, "UTM buildings", solid(std::move(a)), solid(std::move(b)), poses});
    };
    add("UTM buildings, wall to wall",
        building(east, north, house, 9.7),
        building(east + 12.34, north, house, 9.7),
        {});
    add("UTM buildings, wall to wall, shifted",
        building(east, north, house, 9.7),
        building(east + 12.34, north + 2.5, house, 6.1),
        {});
    add("UTM buildings, 1 mm into each other",
        building(east, north, house, 9.7),
        building(east + 12.339, north + 1.1, house, 9.7),
        {});
    add("UTM buildings, turned rows",
        building(east, north, turned, 9.7),
        building(east + 7.071, north + 7.071, turned, 8.2),
        {});
    add("UTM buildings, one in the corner of the other",
        building(east, north, ell, 9.7),
        building(east + 4.4, north + 4.2, {{0, 0}, {4.7, 0}, {4.7, 4.6}, {0, 4.6}}, 9.7),
        {});
    add("UTM buildings, moved there by their poses",
        make_prism(house, 0, 9.7),
        make_prism(house, 0, 9.7),
        {translation_pose(east, north, 519.1), translation_pose(east + 12.34, north, 519.1)});
}

} // namespace

void add_building_scenes(Scenes& scenes) {
    add_terrain(scenes);
    add_walls(scenes);
    add_buildings(scenes);
}

} // namespace cd::tests
