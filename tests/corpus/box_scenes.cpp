#include "tests/corpus/scene_list.hpp"
#include "tests/corpus/solids.hpp"
#include "tests/support/shapes.hpp"

#include <utility>

namespace cd::tests {

namespace {

/// Makes a cube of n^3 cells of this size whose lowest corner is at `low`.
Mesh cube(const Vec3& low, double cell, int n) {
    return make_ticked_box(
        ticks(low.x(), cell, n), ticks(low.y(), cell, n), ticks(low.z(), cell, n));
}

/// 36.87 degrees about z: a rational rotation.
const Quaternion turn_345{3, 0, 0, 1};

PosePair both(const Pose& pose) {
    return {pose, pose};
}

void add_stacks(Scenes& scenes) {
    const Body dyadic = solid(cube(Vec3(0, 0, 0), 0.25, 4));
    const Body decimal = solid(cube(Vec3(0, 0, 0), 0.1, 5));
    const auto add = [&](const char* name, const Body& a, Body b, const PosePair& poses) {
        scenes.push_back({name, "stacked boxes", a, std::move(b), poses});
    };
    const auto at = [](const Vec3& offset) {
        return PosePair{Pose{}, translation_pose(offset.x(), offset.y(), offset.z())};
    };
    add("stacked boxes, dyadic", dyadic, solid(cube(Vec3(0, 0, 1), 0.25, 4)), {});
    add("stacked boxes, dyadic, moved", dyadic, dyadic, at(Vec3(0, 0, 1)));
    add("stacked boxes, dyadic, half a cell aside", dyadic, dyadic, at(Vec3(0.125, 0.125, 1)));
    add("stacked boxes, dyadic, a third of a cell aside",
        dyadic,
        dyadic,
        at(Vec3(0.25 / 3, -0.25 / 3, 1)));
    add("stacked boxes, edge on edge", dyadic, dyadic, at(Vec3(0, 1, 1)));
    add("stacked boxes, corner on corner", dyadic, dyadic, at(Vec3(-1, 1, 1)));
    add("stacked boxes, one step apart", dyadic, dyadic, at(Vec3(0, 0, 0x1.0000000000001p0)));
    add("stacked boxes, one step into each other", dyadic, dyadic, at(Vec3(0, 0, 1 - 0x1p-53)));
    add("stacked boxes, 1e-9 into each other", dyadic, dyadic, at(Vec3(0, 0, 1 - 1e-9)));
    add("stacked boxes, both turned by 3-4-5",
        dyadic,
        dyadic,
        {Pose::from_quaternion(turn_345, Vec3(5, 0, 0)),
         Pose::from_quaternion(turn_345, Vec3(5, 0, 1))});
    add("stacked boxes, upper turned by 3-4-5",
        dyadic,
        dyadic,
        {Pose{}, Pose::from_quaternion(turn_345, Vec3(0.25, 0, 1))});
    add("stacked boxes, decimal", decimal, solid(cube(Vec3(0, 0, 0.5), 0.1, 5)), {});
    add("stacked boxes, decimal, from 0.3",
        solid(cube(Vec3(0.1, 0.2, 0), 0.1, 3)),
        solid(cube(Vec3(0.1, 0.2, 0.3), 0.1, 3)),
        {});
    add("stacked boxes, decimal, moved by 0.1 0.2 0.5", decimal, decimal, at(Vec3(0.1, 0.2, 0.5)));
    add("stacked boxes, decimal, both moved",
        decimal,
        decimal,
        {translation_pose(0.7, 0.1, 0.2), translation_pose(0.7, 0.1, 0.7)});
}

void add_crossings(Scenes& scenes) {
    const Body grid = solid(cube(Vec3(0, 0, 0), 1, 4));
    const Body along_x = solid(make_ticked_box(ticks(0, 1, 4), ticks(1, 1, 1), ticks(1, 1, 1)));
    const Body along_y = solid(make_ticked_box(ticks(1, 1, 1), ticks(0, 1, 4), ticks(1, 1, 1)));
    const Pose turned = Pose::from_quaternion({4, 1, -2, 3}, Vec3(0.3, 7, -2));
    const auto add = [&](const char* name, const Body& a, const Body& b, const PosePair& poses) {
        scenes.push_back({name, "boxes that cross along their grid lines", a, b, poses});
    };
    add("boxes crossing along their grid lines", grid, grid, {Pose{}, translation_pose(2, 2, 2)});
    add("boxes crossing along their grid lines, both posed",
        grid,
        solid(cube(Vec3(2, 1, 3), 1, 4)),
        both(turned));
    add("boxes crossing, one axis in common", grid, grid, {Pose{}, translation_pose(2, 2, 0)});
    add("boxes crossing, end to end", along_x, along_x, {Pose{}, translation_pose(1, 0, 0)});
    add("boxes crossing, bars in one plane", along_x, along_y, {});
    add("boxes crossing, bars in one plane, both posed", along_x, along_y, both(turned));
    add("boxes crossing, a coarse one through a fine one",
        grid,
        solid(make_box_between(Vec3(1, 1, -1), Vec3(3, 3, 5))),
        {});
    add("boxes crossing, generic", grid, grid, {Pose{}, translation_pose(1.3, 0.4, 0.2)});
    add("boxes apart in the corner of a grid", grid, grid, {Pose{}, translation_pose(5, 5, 5)});
}

void add_nested(Scenes& scenes) {
    const Body outer = solid(cube(Vec3(0, 0, 0), 1, 4));
    const Body coarse = solid(make_box_between(Vec3(0, 0, 0), Vec3(4, 4, 4)));
    const auto add = [&](const char* name, const Body& a, Mesh b) {
        scenes.push_back({name, "nested boxes", a, solid(std::move(b)), {}});
    };
    add("nested boxes, free", outer, cube(Vec3(1.5, 1.5, 1.5), 0.5, 2));
    add("nested boxes, on the floor", outer, cube(Vec3(1, 1, 0), 1, 2));
    add("nested boxes, on the floor of a coarse one", coarse, cube(Vec3(1, 1, 0), 1, 2));
    add("nested boxes, in a corner", outer, cube(Vec3(0, 0, 0), 1, 2));
    // The octahedron touches with a corner or an edge only.
    const Mesh diamond = make_sphere(0);
    add("nested, a corner on the floor", outer, translated(diamond, Vec3(2, 2, 1)));
    add("nested, corners on all walls",
        solid(make_box_between(Vec3(-1, -1, -1), Vec3(1, 1, 1))),
        diamond);
    const Body roof = solid(make_prism({{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, 0, 1));
    scenes.push_back({"nested, edges on the walls",
                      "nested boxes",
                      solid(make_box_between(Vec3(-1, -1, -1), Vec3(1, 1, 2))),
                      roof,
                      {}});
    scenes.push_back({"nested boxes, the smaller first",
                      "nested boxes",
                      solid(cube(Vec3(1.5, 1.5, 1.5), 0.5, 2)),
                      outer,
                      {}});
    scenes.push_back({"nested boxes, free, both posed",
                      "nested boxes",
                      outer,
                      solid(cube(Vec3(1.5, 1.5, 1.5), 0.5, 2)),
                      both(Pose::from_quaternion({4, 1, -2, 3}, Vec3(0.3, 7, -2)))});
}

void add_turned(Scenes& scenes) {
    const Body box = solid(cube(Vec3(0, 0, 0), 0.5, 4));
    const Body centred = solid(cube(Vec3(-1, -1, -1), 0.5, 4));
    const double root_half = 0.70710678118654757;
    Mat3 quarter = Mat3::Zero();
    quarter(0, 1) = -1;
    quarter(1, 0) = quarter(2, 2) = 1;
    Mat3 rounded = quarter;
    rounded(0, 0) = rounded(1, 1) = 6.123233995736766e-17;
    Mat3 eighth = Mat3::Identity();
    eighth(0, 0) = eighth(0, 1) = eighth(1, 0) = eighth(1, 1) = root_half;
    eighth(0, 1) = -root_half;
    const auto add = [&](const char* name, const Body& body, const Pose& pose) {
        scenes.push_back({name, "turned boxes", body, body, {Pose{}, pose}});
    };
    add("a box turned by 90 degrees beside it", box, Pose::from_matrix(quarter, Vec3(0, 0, 0)));
    add("a box turned by 90 degrees, rounded, beside it",
        box,
        Pose::from_matrix(rounded, Vec3(0, 0, 0)));
    add("a box turned by 90 degrees, rounded quaternion, on it",
        box,
        Pose::from_quaternion({0.70710678118654746, 0, 0, root_half}, Vec3(2, 0, 2)));
    add("a box turned by 45 degrees, edge on face",
        centred,
        Pose::from_matrix(eighth, Vec3(1 + 1.4142135623730951, 0, 0)));
    add("a box turned by 45 degrees, edge on face, quaternion",
        centred,
        Pose::from_quaternion({0.92387953251128674, 0, 0, 0.38268343236508977},
                              Vec3(1 + 1.4142135623730951, 0, 0)));
    add("a box turned by 45 degrees on top", centred, Pose::from_matrix(eighth, Vec3(0, 0, 2)));
}

void add_selves(Scenes& scenes) {
    const Body box = solid(cube(Vec3(-0.5, -0.5, -0.5), 0.25, 4));
    std::mt19937_64 random(31);
    const Pose quaternion = make_pose(random, 3);
    const Pose matrix = make_matrix_pose(random, 3);
    const auto add = [&](const char* name, const PosePair& poses) {
        scenes.push_back({name, "a body on itself", box, box, poses});
    };
    add("a box on itself", {});
    add("a box on itself, posed by a quaternion", both(quaternion));
    add("a box on itself, posed by a matrix", both(matrix));
    add("a box on itself, a quaternion and its rounded matrix",
        {quaternion, Pose::from_matrix(quaternion.rotation(), quaternion.translation())});
    add("a box on itself, upside down",
        {Pose{}, Pose::from_quaternion({0, 1, 0, 0}, Vec3::Zero())});
}

} // namespace

void add_box_scenes(Scenes& scenes) {
    add_stacks(scenes);
    add_crossings(scenes);
    add_nested(scenes);
    add_turned(scenes);
    add_selves(scenes);
}

} // namespace cd::tests
