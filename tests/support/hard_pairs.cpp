#include "tests/support/hard_pairs.hpp"

#include "tests/support/shapes.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace cd::tests {

namespace {

Corners flat(Corners t) {
    for (Vec3& corner : t) {
        corner.z() = 0;
    }
    return t;
}

PosePair both_posed(std::mt19937_64& random, double reach) {
    return {make_pose(random, reach), make_pose(random, reach)};
}

Pose quarter_turns(std::mt19937_64& random) {
    Mat3 rotation = Mat3::Identity();
    for (std::uint64_t i = 0; i < 1 + random() % 3; ++i) {
        const int axis = static_cast<int>(random() % 3);
        Mat3 turn = Mat3::Zero();
        turn(axis, axis) = 1;
        turn((axis + 1) % 3, (axis + 2) % 3) = -1;
        turn((axis + 2) % 3, (axis + 1) % 3) = 1;
        rotation = Mat3(rotation * turn);
    }
    return Pose::from_matrix(rotation, lattice_point(random, 2));
}

} // namespace

Vec3 lattice_point(std::mt19937_64& random, int reach) {
    const auto coordinate = [&] {
        return static_cast<double>(
            static_cast<int>(random() % (2 * static_cast<unsigned>(reach) + 1)) - reach);
    };
    const double x = coordinate();
    const double y = coordinate();
    const double z = coordinate();
    return {x, y, z};
}

Vec3 point_on(std::mt19937_64& random, const Corners& t) {
    const double s = uniform(random, 0, 1);
    const double r = uniform(random, 0, 1 - s);
    return t[0] + s * (t[1] - t[0]) + r * (t[2] - t[0]);
}

Vec3 nudged(std::mt19937_64& random, Vec3 p) {
    for (int axis = 0; axis < 3; ++axis) {
        const double infinity = std::numeric_limits<double>::infinity();
        if (random() % 2 == 0) {
            p[axis] = std::nextafter(p[axis], random() % 2 == 0 ? infinity : -infinity);
        }
    }
    return p;
}

Corners scaled(Corners t, double factor) {
    for (Vec3& corner : t) {
        corner *= factor;
    }
    return t;
}

Corners random_corners(std::mt19937_64& random, double half_width) {
    return {random_point(random, half_width),
            random_point(random, half_width),
            random_point(random, half_width)};
}

Corners lattice_corners(std::mt19937_64& random, int reach) {
    return {
        lattice_point(random, reach), lattice_point(random, reach), lattice_point(random, reach)};
}

PosedPair nearly_touching(std::mt19937_64& random) {
    const auto some_point = [&](const Corners& t) {
        std::array<double, 3> weight{};
        for (double& w : weight) {
            w = uniform(random, 0.1, 1);
        }
        const std::uint64_t kind = random() % 3;
        for (std::size_t i = 0; i < kind; ++i) {
            weight[(i + random() % 2) % 3] = 0;
        }
        const double sum = weight[0] + weight[1] + weight[2];
        return Vec3((weight[0] * t[0] + weight[1] * t[1] + weight[2] * t[2]) / sum);
    };
    PosedPair c{random_corners(random, 1), random_corners(random, 1), {}};
    switch (random() % 3) {
    case 0:
        c.poses = both_posed(random, 1);
        break;
    case 1:
        c.poses = {make_matrix_pose(random, 1), make_pose(random, 10)};
        break;
    default:
        break;
    }
    // Evaluate products in a fixed order, so that every compiler makes identical pairs.
    const Vec3 from = some_point(c.a);
    const Mat3 ra = c.poses.a.rotation();
    Vec3 target = c.poses.a.translation() - c.poses.b.translation();
    for (int k = 0; k < 3; ++k) {
        target[k] += (ra(k, 0) * from[0] + ra(k, 1) * from[1]) + ra(k, 2) * from[2];
    }
    const double off = std::ldexp(1.0, -44 - static_cast<int>(random() % 12));
    const Mat3 r = c.poses.b.rotation();
    Vec3 shift = -some_point(c.b);
    for (int k = 0; k < 3; ++k) {
        shift[k] += (r(0, k) * target[0] + r(1, k) * target[1]) + r(2, k) * target[2];
    }
    const Vec3 extra = random_point(random, off);
    for (Vec3& corner : c.b) {
        corner += shift + extra;
    }
    return c;
}

std::map<std::string, PairMaker> pair_makers() {
    std::map<std::string, PairMaker> all;
    all["random"] = [](auto& r) {
        return PosedPair{random_corners(r, 1), random_corners(r, 1), {}};
    };
    all["random, both posed"] = [](auto& r) {
        return PosedPair{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.3)};
    };
    all["random, matrix poses"] = [](auto& r) {
        return PosedPair{random_corners(r, 1),
                         random_corners(r, 1),
                         {make_matrix_pose(r, 0.3), make_matrix_pose(r, 0.3)}};
    };
    all["lattice: ties and degenerate ones"] = [](auto& r) {
        return PosedPair{lattice_corners(r, 2), lattice_corners(r, 2), {}};
    };
    all["lattice in one plane"] = [](auto& r) {
        return PosedPair{flat(lattice_corners(r, 3)), flat(lattice_corners(r, 3)), {}};
    };
    all["lattice under quarter turns"] = [](auto& r) {
        return PosedPair{
            lattice_corners(r, 2), lattice_corners(r, 2), {quarter_turns(r), quarter_turns(r)}};
    };
    all["one pose for both: shared vertices"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), {}};
        c.poses.a = c.poses.b = make_pose(r, 10);
        c.b[0] = c.a[r() % 3];
        if (r() % 2 == 0) {
            c.b[1] = c.a[r() % 3];
        }
        return c;
    };
    all["vertex on face, one ulp off"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), {}};
        c.b[0] = nudged(r, point_on(r, c.a));
        return c;
    };
    all["slivers and needles"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.1)};
        c.a[2] = c.a[0] + 0.5 * (c.a[1] - c.a[0]) + random_point(r, 1e-12);
        c.b[1] = c.b[0] + random_point(r, 1e-9);
        return c;
    };
    all["degenerate to segments and points"] = [](auto& r) {
        PosedPair c{lattice_corners(r, 2), lattice_corners(r, 2), {}};
        c.a[1] = c.a[0];
        if (r() % 3 == 0) {
            c.b[2] = 2 * c.b[1] - c.b[0];
        }
        if (r() % 5 == 0) {
            c.a[2] = c.a[0];
        }
        return c;
    };
    all["nearly coplanar"] = [](auto& r) {
        PosedPair c{flat(random_corners(r, 1)), flat(random_corners(r, 1)), {}};
        for (Vec3& corner : c.b) {
            corner.z() = uniform(r, -1, 1) * std::ldexp(1.0, -30 - static_cast<int>(r() % 24));
        }
        return c;
    };
    all["tiny"] = [](auto& r) {
        return PosedPair{
            scaled(lattice_corners(r, 2), 1e-20), scaled(lattice_corners(r, 2), 1e-20), {}};
    };
    all["denormal"] = [](auto& r) {
        return PosedPair{
            scaled(lattice_corners(r, 2), 0x1p-1074), scaled(lattice_corners(r, 2), 0x1p-1074), {}};
    };
    all["huge"] = [](auto& r) {
        return PosedPair{
            scaled(random_corners(r, 1), 0x1p400), scaled(lattice_corners(r, 1), 0x1p400), {}};
    };
    all["far away, small features"] = [](auto& r) {
        PosedPair c{scaled(lattice_corners(r, 2), 1e-3), scaled(lattice_corners(r, 2), 1e-3), {}};
        for (Corners* t : {&c.a, &c.b}) {
            for (Vec3& corner : *t) {
                corner += Vec3(1e7, -2e7, 3e6);
            }
        }
        return c;
    };
    all["far poses that cancel"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), random_corners(r, 1), both_posed(r, 0.2)};
        const Vec3 far(1e7, 1e7, 1e7);
        c.poses.a = Pose::from_quaternion(c.poses.a.quaternion(), c.poses.a.translation() + far);
        c.poses.b = Pose::from_quaternion(c.poses.b.quaternion(), c.poses.b.translation() + far);
        return c;
    };
    all["quaternions of any norm"] = [](auto& r) {
        PosedPair c{lattice_corners(r, 2), lattice_corners(r, 2), {}};
        const auto small = [&] { return static_cast<double>(1 + r() % 3); };
        const Vec3 offset = lattice_point(r, 1);
        c.poses.a = Pose::from_quaternion({small(), 0, 0, small()}, offset);
        c.poses.b = Pose::from_quaternion({small() * 1e-9, 0, small() * 1e-9, 0}, Vec3::Zero());
        return c;
    };
    all["corners, edges and faces that nearly meet in the world"] = nearly_touching;
    all["edges that cross in a point"] = [](auto& r) {
        const Vec3 meeting = lattice_point(r, 2);
        const Vec3 along_a = lattice_point(r, 3);
        const Vec3 along_b = lattice_point(r, 3);
        PosedPair c{{meeting - along_a, meeting + along_a, lattice_point(r, 4)},
                    {meeting - along_b, meeting + along_b, lattice_point(r, 4)},
                    {}};
        if (r() % 2 == 0) {
            c.b[0] = nudged(r, c.b[0]);
        }
        return c;
    };
    all["one large, one small"] = [](auto& r) {
        PosedPair c{scaled(random_corners(r, 1), 1e6), scaled(random_corners(r, 1), 1e-6), {}};
        const Vec3 place = point_on(r, c.a);
        for (Vec3& corner : c.b) {
            corner += place;
        }
        return c;
    };
    all["matrices that are not rigid"] = [](auto& r) {
        PosedPair c{lattice_corners(r, 2), lattice_corners(r, 2), {}};
        Mat3 shear = Mat3::Identity();
        shear(0, 1) = 0.5;
        shear(2, 2) = r() % 3 == 0 ? 0 : -2; // Flat in some cases, mirrored in others.
        c.poses.a = Pose::from_matrix(shear, Vec3::Zero());
        return c;
    };
    all["identical"] = [](auto& r) {
        PosedPair c{random_corners(r, 1), {}, {}};
        c.b = {c.a[1], c.a[2], c.a[0]};
        c.poses.a = c.poses.b = make_matrix_pose(r, 100);
        return c;
    };
    return all;
}

void scale_far_apart(std::mt19937_64& random, PosedPair& pair) {
    for (Corners* const corners : {&pair.a, &pair.b}) {
        for (Vec3& corner : *corners) {
            for (int k = 0; k < 3; ++k) {
                corner[k] *= std::ldexp(1.0, (static_cast<int>(random() % 5) - 3) * 180);
            }
        }
    }
}

PosedPair turned_about_an_axis(std::mt19937_64& random) {
    const auto axis = static_cast<int>(random() % 3);
    const double step = random() % 2 == 0 ? 1 : 0.1;
    const auto turn = [&](int kind) {
        // Turn by any angle, by a half turn about a transverse axis, or not at all.
        const double angle = kind == 0 ? 1 : static_cast<double>(random() % 7) / 3;
        Quaternion q{kind == 1 ? 0.0 : angle, 0, 0, 0};
        std::array<double*, 3> vector{&q.x, &q.y, &q.z};
        if (kind == 1) {
            *vector[static_cast<std::size_t>((axis + 1) % 3)] = 1;
            *vector[static_cast<std::size_t>((axis + 2) % 3)] = angle;
        } else {
            q.w = kind == 0 ? std::ldexp(static_cast<double>(random()), -64) + 0.1 : 1;
            *vector[static_cast<std::size_t>(axis)] = kind == 0 ? angle : 0;
        }
        return q;
    };
    PosedPair c{
        scaled(lattice_corners(random, 2), step), scaled(lattice_corners(random, 2), step), {}};
    for (Corners* corners : {&c.a, &c.b}) {
        if (random() % 2 == 0) {
            Vec3& corner = (*corners)[random() % 3];
            const double height = corner[axis];
            corner = Vec3::Zero();
            corner[axis] = height;
        }
    }
    const int kind_a = static_cast<int>(random() % 3);
    c.poses.a = Pose::from_quaternion(turn(kind_a), Vec3::Zero());
    const Quaternion q = turn(static_cast<int>(random() % 3));
    Vec3 translation = Vec3::Zero();
    const Pose turned = Pose::from_quaternion(q, translation);
    const std::size_t i = random() % 3;
    const Vec3 apart = c.poses.a.apply(c.a[i]) - turned.apply(c.b[random() % 3]);
    if (random() % 2 == 0) {
        translation = apart;
    } else {
        translation[axis] = step * static_cast<double>(random() % 5);
    }
    c.poses.b = Pose::from_quaternion(q, translation);
    return c;
}

} // namespace cd::tests
