#include "tests/corpus/scene_list.hpp"
#include "tests/corpus/solids.hpp"
#include "tests/support/shapes.hpp"

#include <utility>

namespace cd::tests {

namespace {

void add_spheres(Scenes& scenes) {
    const Body sphere = solid(make_sphere(3));
    const auto add = [&](const char* name, const PosePair& poses) {
        scenes.push_back({name, "spheres", sphere, sphere, poses});
    };
    const auto at = [](double x, double y, double z) {
        return PosePair{Pose{}, translation_pose(x, y, z)};
    };
    std::mt19937_64 random(41);
    const Pose quaternion = make_pose(random, 3);
    const Pose rounded = Pose::from_matrix(quaternion.rotation(), quaternion.translation());
    add("a sphere on itself", {});
    add("a sphere on itself, posed", {quaternion, quaternion});
    add("a sphere on itself, posed by a rounded matrix", {rounded, rounded});
    add("a sphere on itself, a quaternion and its rounded matrix", {quaternion, rounded});
    add("a sphere on itself, turned a quarter",
        {Pose{}, Pose::from_quaternion({1, 0, 0, 1}, Vec3::Zero())});
    add("tangent spheres", at(2, 0, 0));
    add("tangent spheres, one step apart", at(0, 0x1.0000000000001p1, 0));
    add("tangent spheres, one step into each other", at(0, 0, 2 - 0x1p-52));
    add("tangent spheres, posed by rational turns",
        {Pose::from_quaternion({3, 0, 0, 1}, Vec3(7, 7, 7)),
         Pose::from_quaternion({1, 2, 2, 4}, Vec3(7, 7, 9))});
    // No vertex has the direction (4/5, 3/5): faces meet nominally.
    add("tangent spheres, face to face", at(1.6, 1.2, 0));
    add("spheres, crossing", at(1.1, 0.3, 0.2));
    add("spheres, apart", at(1.6, 1.6, 0.1));
    const auto inside = [&](const char* name, double factor, const Vec3& offset) {
        scenes.push_back({name,
                          "spheres",
                          sphere,
                          solid(scaled(make_sphere(2), factor)),
                          {Pose{}, translation_pose(offset.x(), offset.y(), offset.z())}});
    };
    inside("a sphere inside", 0.5, Vec3(0.1, 0.2, 0.1));
    inside("a sphere inside, tangent", 0.5, Vec3(0.5, 0, 0));
    inside("a sphere inside, one step from the wall", 0.5, Vec3(0, 0.5 - 0x1p-53, 0));
}

void add_tori(Scenes& scenes) {
    const Body torus = solid(make_round_torus(1, 0.25, 3, 2));
    const Pose upright = Pose::from_quaternion({1, 1, 0, 0}, Vec3(1, 0, 0));
    const auto add = [&](const char* name, const PosePair& poses) {
        scenes.push_back({name, "tori", torus, torus, poses});
    };
    std::mt19937_64 random(43);
    add("tori, linked", {Pose{}, upright});
    add("tori, stacked", {Pose{}, translation_pose(0, 0, 0.5)});
    add("tori, side by side", {Pose{}, translation_pose(2.5, 0, 0)});
    add("tori, crossing", {make_pose(random, 0.3), make_pose(random, 0.5)});
    add("tori, one on itself", {upright, upright});
}

/// Gears have 16 teeth between radii 0.9 and 1.1; their axes are nominally 2 apart.
void add_gears(Scenes& scenes) {
    const Body gear = solid(make_gear(4, 0.9, 1.1, 0.25, 2));
    // Turned by half a tooth (11.25 degrees), so that a gap faces a tooth.
    const Quaternion half_tooth{0.99518472667219693, 0, 0, 0.098017140329560604};
    const Pose meshing = Pose::from_quaternion(half_tooth, Vec3(2, 0, 0));
    const auto add = [&](const char* name, const PosePair& poses) {
        scenes.push_back({name, "gears", gear, gear, poses});
    };
    const Quaternion rational{5, 1, -2, 3};
    add("gears, meshing", {Pose{}, meshing});
    add("gears, tip to tip", {Pose{}, translation_pose(2.2, 0, 0)});
    add("gears, tip into tip", {Pose{}, translation_pose(2.2 - 1e-12, 0, 0)});
    add("gears, stacked", {Pose{}, translation_pose(0, 0, 0.25)});
    add("gears, stacked by half a tooth",
        {Pose{}, Pose::from_quaternion(half_tooth, Vec3(0, 0, 0.25))});
    // The rational turn maps the x axis to (1, 2, 2) / 3.
    add("gears, meshing, both posed",
        {Pose::from_quaternion(rational, Vec3(0.1, 0.2, 0.3)),
         Pose::from_quaternion(rational * half_tooth,
                               Vec3(0.1 + 2.0 / 3, 0.2 + 4.0 / 3, 0.3 + 4.0 / 3))});
    add("gears, one on itself, posed",
        {Pose::from_quaternion(rational, Vec3(0.1, 0.2, 0.3)),
         Pose::from_quaternion(rational, Vec3(0.1, 0.2, 0.3))});
    add("gears, one on itself, a tooth further",
        {Pose{},
         Pose::from_quaternion({0.98078528040323043, 0, 0, 0.19509032201612825}, Vec3::Zero())});
}

} // namespace

void add_round_scenes(Scenes& scenes) {
    add_spheres(scenes);
    add_tori(scenes);
    add_gears(scenes);
}

} // namespace cd::tests
