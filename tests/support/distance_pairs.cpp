#include "tests/support/distance_pairs.hpp"

#include "tests/support/brink_boxes.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cd::tests {

namespace {

double size_of(const Corners& t) {
    double size = 0;
    for (const Vec3& corner : t) {
        size = std::max(size, (corner - t[0]).cwiseAbs().maxCoeff());
    }
    return size;
}

Corners shifted(Corners t, const Vec3& by) {
    for (Vec3& corner : t) {
        corner += by;
    }
    return t;
}

Corners at_height(Corners t, double z) {
    for (Vec3& corner : t) {
        corner.z() = z;
    }
    return t;
}

/// A whole number of tenths, as a decimal file has it.
double tenths(std::mt19937_64& random, int reach) {
    const auto span = 2 * static_cast<unsigned>(reach) + 1;
    return static_cast<double>(static_cast<int>(random() % span) - reach) / 10;
}

Corners decimal_corners(std::mt19937_64& random, int reach) {
    Corners t;
    for (Vec3& corner : t) {
        for (int k = 0; k < 3; ++k) {
            corner[k] = tenths(random, reach);
        }
    }
    return t;
}

/// Gives both bodies one pose, so that their distance is that of the given corners.
PosedPair posed_together(std::mt19937_64& random, PosedPair c) {
    switch (random() % 3) {
    case 0:
        c.poses.a = c.poses.b = make_pose(random, 10);
        break;
    case 1:
        c.poses.a = c.poses.b = translation_pose(tenths(random, 99), 0, tenths(random, 99));
        break;
    default:
        break;
    }
    return c;
}

Pose scaled_quaternion(std::mt19937_64& random, double norm, double reach) {
    const Pose pose = make_pose(random, reach);
    const Quaternion& q = pose.quaternion();
    return Pose::from_quaternion({norm * q.w, norm * q.x, norm * q.y, norm * q.z},
                                 pose.translation());
}

Pose skew_matrix(std::mt19937_64& random, double reach) {
    Mat3 matrix;
    for (int i = 0; i < 9; ++i) {
        matrix(i / 3, i % 3) = uniform(random, -2, 2);
    }
    return Pose::from_matrix(matrix, random_point(random, reach));
}

void add_plates(std::map<std::string, PairMaker>& all) {
    all["parallel plates, decimal gap"] = [](auto& r) {
        const double z = tenths(r, 50);
        return posed_together(r,
                              {at_height(decimal_corners(r, 20), z),
                               at_height(decimal_corners(r, 20), z + (1 + tenths(r, 9))),
                               {}});
    };
    all["parallel plates, whole gap"] = [](auto& r) {
        const auto gap = static_cast<double>(1 + r() % 5);
        return posed_together(
            r, {at_height(lattice_corners(r, 3), 0), at_height(lattice_corners(r, 3), gap), {}});
    };
    all["gap midway between two doubles"] = [](auto& r) {
        const double below = -0x1p-53 * static_cast<double>(1 + r() % 4);
        return PosedPair{
            at_height(lattice_corners(r, 3), below), at_height(lattice_corners(r, 3), 1), {}};
    };
    all["decimal coordinates"] = [](auto& r) {
        return posed_together(
            r, {decimal_corners(r, 30), shifted(decimal_corners(r, 30), Vec3(0, 0, 6.1)), {}});
    };
    all["corner over corner"] = [](auto& r) {
        PosedPair c{lattice_corners(r, 3), lattice_corners(r, 3), {}};
        for (std::size_t i = 0; i < 3; ++i) {
            c.a[i].z() = -std::abs(c.a[i].z());
            c.b[i].z() = std::abs(c.b[i].z());
        }
        c.a[r() % 3] = Vec3::Zero();
        c.b[r() % 3] = Vec3::Zero();
        c.b = shifted(c.b, Vec3(0, 0, 0.1 * static_cast<double>(1 + r() % 20)));
        return posed_together(r, c);
    };
}

void add_extremes(std::map<std::string, PairMaker>& all) {
    all["denormal gap"] = [](auto& r) {
        const double gap = 0x1p-1074 * static_cast<double>(1 + r() % 5);
        return PosedPair{
            at_height(lattice_corners(r, 3), 0), at_height(lattice_corners(r, 3), gap), {}};
    };
    all["denormal coordinates apart"] = [](auto& r) {
        return PosedPair{scaled(lattice_corners(r, 4), 0x1p-1074),
                         shifted(scaled(lattice_corners(r, 4), 0x1p-1074), Vec3(0, 0, 0x1p-1071)),
                         {}};
    };
    all["2^400 apart"] = [](auto& r) {
        const Vec3 by(0, 0, 0x1p402 * uniform(r, 1, 2));
        return PosedPair{scaled(random_corners(r, 1), 0x1p400),
                         shifted(scaled(random_corners(r, 1), 0x1p400), by),
                         {make_pose(r, 1), make_pose(r, 1)}};
    };
    all["slivers of 1e12"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), {make_pose(r, 2), make_pose(r, 2)}};
        c.a[2] = c.a[0] + uniform(r, 0, 1) * (c.a[1] - c.a[0]) + random_point(r, 1e-12);
        c.b[2] = c.b[1] + uniform(r, 0, 1e-12) * (c.b[0] - c.b[1]);
        return c;
    };
    all["points and segments"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), {make_pose(r, 2), make_pose(r, 2)}};
        c.a[1] = c.a[0];
        if (r() % 2 == 0) {
            c.a[2] = c.a[0];
        }
        if (r() % 2 == 0) {
            c.b[2] = 2 * c.b[1] - c.b[0];
        }
        return c;
    };
    all["coordinates of a map grid"] = [](auto& r) {
        const Vec3 far(4.5e5, 5.4e6, 120);
        return posed_together(r,
                              {shifted(scaled(lattice_corners(r, 9), 1e-3), far),
                               shifted(scaled(lattice_corners(r, 9), 1e-3), far),
                               {}});
    };
}

void add_poses(std::map<std::string, PairMaker>& all) {
    all["apart under two quaternions"] = [](auto& r) {
        return PosedPair{
            random_corners(r, 1), random_corners(r, 1), {make_pose(r, 3), make_pose(r, 3)}};
    };
    all["quaternions of norm 1e-3 and 1e3"] = [](auto& r) {
        return PosedPair{random_corners(r, 1),
                         random_corners(r, 1),
                         {scaled_quaternion(r, 1e-3, 3), scaled_quaternion(r, 1e3, 3)}};
    };
    all["skew matrices"] = [](auto& r) {
        return PosedPair{
            random_corners(r, 1), random_corners(r, 1), {skew_matrix(r, 5), skew_matrix(r, 5)}};
    };
    all["a skew matrix and a quaternion"] = [](auto& r) {
        return PosedPair{
            lattice_corners(r, 2), lattice_corners(r, 2), {skew_matrix(r, 5), make_pose(r, 5)}};
    };
}

} // namespace

PosedPair moved_apart(std::mt19937_64& random, PosedPair c) {
    double size = std::max(size_of(c.a), size_of(c.b));
    size = size > 0 ? size : 1;
    const double gap = size * std::pow(10, uniform(random, -17, 3));
    Vec3 direction = random() % 2 == 0 ? random_point(random, 1) : lattice_point(random, 1);
    if (direction == Vec3::Zero()) {
        direction.z() = 1;
    }
    c.poses.b = with_translation(c.poses.b, c.poses.b.translation() + gap * direction);
    return c;
}

std::map<std::string, PairMaker> distance_pair_makers() {
    std::map<std::string, PairMaker> all;
    for (const auto& [name, make] : pair_makers()) {
        all[name + ", apart"] = [maker = make](auto& r) { return moved_apart(r, maker(r)); };
    }
    add_plates(all);
    add_extremes(all);
    add_poses(all);
    return all;
}

std::vector<double> bounds_around(std::mt19937_64& random, double rounded) {
    constexpr double most = std::numeric_limits<double>::max();
    const double unit = std::pow(10, std::round(std::log10(std::max(rounded, 1e-300))) - 3);
    return {0,
            rounded,
            std::nextafter(rounded, 0.0),
            std::nextafter(rounded, most),
            std::min(most, std::round(rounded / unit) * unit),
            std::min(most, rounded * (1 + std::ldexp(uniform(random, -1, 1), -20))),
            std::min(most, rounded * uniform(random, 0, 2)),
            std::numeric_limits<double>::denorm_min(),
            most};
}

} // namespace cd::tests
