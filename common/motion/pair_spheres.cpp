#include "common/motion/pair_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace cd {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Exceeds what frames that are not quite orthonormal, and the roundings of a radius, add to it.
constexpr double radius_factor = 1 + 0x1p-16;

struct Sphere {
    Vec3 center;
    double radius;
};

Sphere sphere_around(const WideNode& node) {
    constexpr double half = 127.5; // Of the 255 steps that a node can have.
    Vec3 center(node.origin[0], node.origin[1], node.origin[2]);
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double step = half * static_cast<double>(node.steps[k]);
        center += step * Vec3(node.columns[0][k], node.columns[1][k], node.columns[2][k]);
        square += step * step;
    }
    return {center, radius_factor * std::sqrt(square)};
}

Sphere sphere_around(const ObbNode& node) {
    double square = 0;
    for (const float half : node.half) {
        square += static_cast<double>(half) * static_cast<double>(half);
    }
    return {Vec3(node.center[0], node.center[1], node.center[2]),
            radius_factor * std::sqrt(square)};
}

Sphere sphere_around(const TreeView& tree) {
    return tree.wide.nodes.empty() ? sphere_around(tree.nodes.front())
                                   : sphere_around(tree.wide.nodes.front());
}

const void* root_of(const TreeView& tree) {
    return tree.wide.nodes.empty() ? static_cast<const void*>(tree.nodes.data())
                                   : static_cast<const void*>(tree.wide.nodes.data());
}

/// The subtrees of one body, each once.
struct Side {
    std::unordered_map<const void*, std::uint32_t> numbers;
    std::vector<Vec3> centers;
    std::vector<double> radii;

    std::uint32_t number_of(const TreeView& tree) {
        const auto [place, is_new] =
            numbers.try_emplace(root_of(tree), static_cast<std::uint32_t>(centers.size()));
        if (is_new) {
            const Sphere sphere = sphere_around(tree);
            centers.push_back(sphere.center);
            radii.push_back(sphere.radius);
        }
        return place->second;
    }
};

} // namespace

PairSpheres::PairSpheres(std::span<const SubtreePair> pairs) {
    std::array<Side, 2> sides;
    pairs_.reserve(pairs.size());
    for (const SubtreePair& pair : pairs) {
        const std::uint32_t a = sides[0].number_of(pair.a);
        const std::uint32_t b = sides[1].number_of(pair.b);
        pairs_.push_back({a, b, sides[0].radii[a] + sides[1].radii[b]});
    }
    for (std::size_t side = 0; side < 2; ++side) {
        centers_[side] = std::move(sides[side].centers);
        places_[side].resize(centers_[side].size());
        for (const Vec3& center : centers_[side]) {
            size_ = std::max(size_, center.cwiseAbs().maxCoeff());
        }
    }
}

void PairSpheres::place(const PosePair& poses, double distance) {
    const std::array<const Pose*, 2> of{&poses.a, &poses.b};
    double size = size_;
    bool are_rigid = true;
    for (std::size_t side = 0; side < 2; ++side) {
        const Mat3 rotation = of[side]->rotation();
        const Vec3& translation = of[side]->translation();
        std::ranges::transform(centers_[side], places_[side].begin(), [&](const Vec3& center) {
            return Vec3(rotation * center + translation);
        });
        size = std::max(size, translation.cwiseAbs().maxCoeff());
        are_rigid = are_rigid && of[side]->kind() == Pose::Kind::Quaternion;
    }
    // A place errs by below 2^-46 of the largest coordinate, and a matrix may stretch a sphere.
    reach_ = are_rigid ? (1 + 0x1p-40) * distance + 0x1p-40 * size : infinity;
}

} // namespace cd
