#include "tests/support/shot_cases.hpp"

#include "tests/support/hard_pairs.hpp"
#include "tests/support/shapes.hpp"

#include <cmath>
#include <cstddef>

namespace cd::tests {

namespace {

/// A line through a point, with ends at whole numbers of steps on both sides.
Segment line_through(std::mt19937_64& random, const Vec3& point, int reach) {
    Vec3 step = lattice_point(random, reach);
    if (step == Vec3::Zero()) {
        step.x() = 1;
    }
    return {point - static_cast<double>(1 + random() % 4) * step,
            point + static_cast<double>(1 + random() % 4) * step};
}

PosePair some_poses(std::mt19937_64& random) {
    switch (random() % 4) {
    case 0: {
        const Pose pose = make_pose(random, 10);
        return {pose, pose};
    }
    case 1:
        return {translation_pose(0.1, 2, -3), translation_pose(0.1, 2, -3)};
    case 2: {
        const Pose pose = make_matrix_pose(random, 2);
        return {pose, pose};
    }
    default:
        return {};
    }
}

std::vector<Corners> scaled_all(std::vector<Corners> triangles, double factor) {
    for (Corners& t : triangles) {
        t = scaled(t, factor);
    }
    return triangles;
}

Segment scaled_line(const Segment& line, double factor) {
    return {line.p * factor, line.q * factor};
}

Pose scaled_quaternion(std::mt19937_64& random, double norm) {
    const Pose pose = make_pose(random, 1);
    const Quaternion& q = pose.quaternion();
    return Pose::from_quaternion({norm * q.w, norm * q.x, norm * q.y, norm * q.z},
                                 pose.translation());
}

Pose skew_matrix(std::mt19937_64& random) {
    Mat3 matrix;
    for (int i = 0; i < 9; ++i) {
        matrix(i / 3, i % 3) = static_cast<double>(static_cast<int>(random() % 9) - 4) / 2;
    }
    return Pose::from_matrix(matrix, lattice_point(random, 2));
}

void add_ties(std::map<std::string, ShotMaker>& all) {
    all["through a vertex"] = [](auto& r) {
        const Vec3 hub = lattice_point(r, 3);
        return ShotCase{make_fan(r, hub, 4), line_through(r, hub, 2), some_poses(r)};
    };
    all["through the middle of an edge"] = [](auto& r) {
        ShotCase c{make_fan(r, lattice_point(r, 3), 4), {}, some_poses(r)};
        c.line = line_through(r, 0.5 * (c.triangles[0][0] + c.triangles[0][1]), 2);
        return c;
    };
    all["along an edge"] = [](auto& r) {
        ShotCase c{make_fan(r, lattice_point(r, 3), 4), {}, some_poses(r)};
        const Vec3 along = c.triangles[0][1] - c.triangles[0][0];
        const double from = static_cast<double>(r() % 5) / 2 - 1;
        c.line = {c.triangles[0][0] + from * along,
                  c.triangles[0][0] + (from + static_cast<double>(1 + r() % 4) / 2) * along};
        return c;
    };
    all["in a face"] = [](auto& r) {
        ShotCase c{make_fan(r, lattice_point(r, 3), 4), {}, some_poses(r)};
        const Corners& t = c.triangles[0];
        const auto point = [&] {
            const double u = static_cast<double>(r() % 9) / 4 - 1;
            const double v = static_cast<double>(r() % 9) / 4 - 1;
            return Vec3(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
        };
        c.line = {point(), point()};
        return c;
    };
    all["coincident faces"] = [](auto& r) {
        ShotCase c{{lattice_corners(r, 3), lattice_corners(r, 3)}, {}, some_poses(r)};
        const Corners t = c.triangles[0];
        c.triangles.push_back({t[2], t[1], t[0]});
        c.triangles.push_back({t[1], t[2], t[0]});
        c.triangles.push_back({0.5 * (t[0] + t[1]), t[1], t[2]});
        c.line = line_through(r, 0.25 * (t[0] + t[1]) + 0.5 * t[2], 2);
        return c;
    };
    all["an end in the plane"] = [](auto& r) {
        ShotCase c{{lattice_corners(r, 3)}, {}, some_poses(r)};
        const Corners& t = c.triangles[0];
        const Vec3 end = 0.25 * (t[0] + t[1]) + 0.5 * t[2];
        c.line = {end, lattice_point(r, 4)};
        if (r() % 2 == 0) {
            std::swap(c.line.p, c.line.q);
        }
        return c;
    };
    all["a segment that is a point"] = [](auto& r) {
        ShotCase c{make_fan(r, lattice_point(r, 2), 3), {}, some_poses(r)};
        const Corners& t = c.triangles[0];
        c.line.p = r() % 3 == 0   ? t[0]
                   : r() % 2 == 0 ? Vec3(0.5 * (t[1] + t[2]))
                                  : Vec3(0.25 * (t[0] + t[1]) + 0.5 * t[2]);
        c.line.q = c.line.p;
        return c;
    };
    all["parallel to the axes of a grid"] = [](auto& r) {
        ShotCase c;
        const auto axis = static_cast<int>(r() % 3);
        for (int i = 0; i < 6; ++i) {
            c.triangles.push_back(lattice_corners(r, 2));
        }
        c.line.p = 0.5 * lattice_point(r, 4);
        c.line.q = c.line.p;
        c.line.p[axis] = -5;
        c.line.q[axis] = 5;
        c.poses = some_poses(r);
        return c;
    };
}

void add_depths(std::map<std::string, ShotMaker>& all) {
    all["depths that round alike"] = [](auto& r) {
        ShotCase c;
        for (int i = 0; i < 12; ++i) {
            const double z = 1 + std::ldexp(static_cast<double>(r() % 8), -52);
            c.triangles.push_back({Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(0, 1, z)});
            c.triangles.back()[r() % 3].z() += std::ldexp(static_cast<double>(r() % 4), -52);
        }
        c.line = {Vec3(0.1, 0.2, -4 - static_cast<double>(r() % 9)), Vec3(0.1, 0.2, 17)};
        c.poses = some_poses(r);
        return c;
    };
    all["more depths that round alike than ranks"] = [](auto& r) {
        ShotCase c;
        for (int i = 0; i < 300; ++i) {
            const double z = std::ldexp(static_cast<double>(r() % 290), -70);
            c.triangles.push_back({Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(0, 1, z)});
        }
        c.line = {Vec3(0.1, 0.2, -1), Vec3(0.1, 0.2, 2)};
        return c;
    };
    all["depths midway between two doubles, or nearly"] = [](auto& r) {
        ShotCase c;
        for (int i = 1; i < 8; ++i) {
            const double z = i;
            const double above = std::nextafter(z, 9.0);
            c.triangles.push_back({Vec3(-1, -1, z), Vec3(1, -1, z), Vec3(0, 1, above)});
        }
        // At y = 0 the triangles are half a step high.
        const double y = r() % 2 == 0 ? 0 : std::ldexp(1.0, -40 - static_cast<int>(r() % 12));
        c.line = {Vec3(0, r() % 2 == 0 ? y : -y, 0), Vec3(0, 0, 16)};
        c.line.q.y() = c.line.p.y();
        c.poses = some_poses(r);
        return c;
    };
    all["a long line and small triangles"] = [](auto& r) {
        ShotCase c{{}, {}, {make_pose(r, 1), {}}};
        for (int i = 0; i < 6; ++i) {
            c.triangles.push_back(scaled(random_corners(r, 1), 1e-4));
        }
        c.line = {Vec3(uniform(r, -1e-4, 1e-4), 0, -1e8), Vec3(0, uniform(r, -1e-4, 1e-4), 1e8)};
        c.poses.b = Pose::from_quaternion(make_pose(r, 1).quaternion(), c.poses.a.translation());
        return c;
    };
}

void add_extremes(std::map<std::string, ShotMaker>& all) {
    all["slivers through vertices"] = [](auto& r) {
        ShotCase c{{}, {}, {make_pose(r, 2), make_pose(r, 2)}};
        for (int i = 0; i < 4; ++i) {
            Corners t = random_corners(r, 1);
            t[2] = t[0] + uniform(r, 0, 1) * (t[1] - t[0]) + random_point(r, 1e-12);
            c.triangles.push_back(t);
        }
        const Vec3 at = c.poses.b.rotation().transpose() *
                        (c.poses.a.apply(c.triangles[0][r() % 3]) - c.poses.b.translation());
        const Vec3 step = random_point(r, 1);
        c.line = {at - step, at + 2 * step};
        return c;
    };
    all["no area"] = [](auto& r) {
        ShotCase c{{}, {}, some_poses(r)};
        for (int i = 0; i < 6; ++i) {
            Corners t = lattice_corners(r, 2);
            t[1] = r() % 3 == 0 ? t[0] : t[0] + 2 * (t[2] - t[0]);
            if (r() % 4 == 0) {
                t[1] = t[2] = t[0];
            }
            c.triangles.push_back(t);
        }
        c.line = line_through(r, c.triangles[0][0], 2);
        return c;
    };
    all["a far origin"] = [](auto& r) {
        const Vec3 far(4.5e5, 5.4e6, 120);
        const Vec3 hub = lattice_point(r, 3);
        ShotCase c{make_fan(r, hub, 4), line_through(r, hub, 2), some_poses(r)};
        c.triangles = scaled_all(c.triangles, 1e-3);
        c.line = scaled_line(c.line, 1e-3);
        for (Corners& t : c.triangles) {
            for (Vec3& corner : t) {
                corner += far;
            }
        }
        c.line = {c.line.p + far, c.line.q + far};
        return c;
    };
    for (const auto& [name, scale] : {std::pair{"huge, through a vertex", 0x1p400},
                                      std::pair{"tiny, through a vertex", 0x1p-300},
                                      std::pair{"denormal, through a vertex", 0x1p-1074}}) {
        all[name] = [factor = scale](auto& r) {
            const Vec3 hub = lattice_point(r, 3);
            return ShotCase{scaled_all(make_fan(r, hub, 4), factor),
                            scaled_line(line_through(r, hub, 2), factor),
                            {}};
        };
    }
}

void add_poses(std::map<std::string, ShotMaker>& all) {
    all["quaternions of norm 1e-3 and 1e3, and lines"] = [](auto& r) {
        ShotCase c{{}, {}, {scaled_quaternion(r, 1e-3), scaled_quaternion(r, 1e3)}};
        for (int i = 0; i < 6; ++i) {
            c.triangles.push_back(random_corners(r, 1));
        }
        c.line = {random_point(r, 2), random_point(r, 2)};
        return c;
    };
    all["quaternions that coincide but for their norm"] = [](auto& r) {
        const Vec3 hub = lattice_point(r, 3);
        const auto small = [&] { return static_cast<double>(r() % 4); };
        const Quaternion q{1 + small(), small(), small(), small()};
        const Vec3 offset = lattice_point(r, 5);
        return ShotCase{make_fan(r, hub, 4),
                        line_through(r, hub, 2),
                        {Pose::from_quaternion(q, offset),
                         Pose::from_quaternion({3 * q.w, 3 * q.x, 3 * q.y, 3 * q.z}, offset)}};
    };
    all["skew matrices through a vertex"] = [](auto& r) {
        const Vec3 hub = lattice_point(r, 3);
        const Pose pose = skew_matrix(r);
        return ShotCase{make_fan(r, hub, 4), line_through(r, hub, 2), {pose, pose}};
    };
    all["two skew matrices and lines"] = [](auto& r) {
        ShotCase c{{}, {}, {skew_matrix(r), skew_matrix(r)}};
        for (int i = 0; i < 6; ++i) {
            c.triangles.push_back(lattice_corners(r, 2));
        }
        c.line = {lattice_point(r, 3), lattice_point(r, 3)};
        return c;
    };
    all["quarter turns"] = [](auto& r) {
        const Vec3 hub = lattice_point(r, 2);
        ShotCase c{make_fan(r, hub, 3), line_through(r, hub, 2), {}};
        c.poses.a = c.poses.b = Pose::from_quaternion({0.5, 0.5, 0.5, -0.5}, lattice_point(r, 3));
        return c;
    };
    all["random triangles"] = [](auto& r) {
        ShotCase c{{}, {}, {make_pose(r, 0.5), make_pose(r, 0.5)}};
        for (int i = 0; i < 10; ++i) {
            c.triangles.push_back(random_corners(r, 1));
        }
        const Vec3 step = random_point(r, 2);
        c.line = {random_point(r, 0.3) - step, random_point(r, 0.3) + step};
        return c;
    };
}

} // namespace

std::vector<Corners> make_fan(std::mt19937_64& random, const Vec3& hub, int reach) {
    std::vector<Vec3> rim;
    while (rim.size() < 3 + random() % 4) {
        rim.push_back(lattice_point(random, reach));
    }
    std::vector<Corners> fan;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        fan.push_back({hub, rim[i], rim[(i + 1) % rim.size()]});
    }
    return fan;
}

std::map<std::string, ShotMaker> shot_makers() {
    std::map<std::string, ShotMaker> all;
    for (const auto& [name, make] : pair_makers()) {
        all["one triangle: " + name] = [maker = make](auto& r) {
            const PosedPair c = maker(r);
            return ShotCase{{c.a}, {c.b[0], c.b[1]}, c.poses};
        };
    }
    add_ties(all);
    add_depths(all);
    add_extremes(all);
    add_poses(all);
    return all;
}

} // namespace cd::tests
