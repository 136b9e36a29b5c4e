#include "tests/corpus/pair_makers.hpp"
#include "tests/support/shapes.hpp"

#include <array>
#include <utility>

namespace cd::tests {

namespace {

/// Returns 10^-k for k in 6..12, the ratio of width to length.
double thinness(std::mt19937_64& random) {
    constexpr std::array<double, 7> thin{1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
    return thin[random() % thin.size()];
}

void move_by(Corners& t, const Vec3& offset) {
    for (Vec3& corner : t) {
        corner += offset;
    }
}

/// Moves B so that a point of it is nominally on A.
void bring_together(std::mt19937_64& random, PosedPair& pair) {
    const Vec3 target = point_on(random, pair.a);
    move_by(pair.b, target - point_on(random, pair.b));
}

/// Makes three corners that are collinear up to a share of their length.
Corners sliver(std::mt19937_64& random) {
    Corners t = random_corners(random, 1);
    const double thin = thinness(random);
    const double along = uniform(random, 0.1, 0.9);
    t[2] = t[0] + along * (t[1] - t[0]) + random_point(random, thin);
    return t;
}

/// Makes two adjacent corners and a distant third.
Corners needle(std::mt19937_64& random) {
    Corners t = random_corners(random, 1);
    const double thin = thinness(random);
    t[1] = t[0] + random_point(random, thin);
    return t;
}

PosedPair thin_against(std::mt19937_64& random, Corners (*make)(std::mt19937_64&)) {
    PosedPair pair{make(random), {}, {}};
    pair.b = random() % 2 == 0 ? make(random) : random_corners(random, 1);
    if (random() % 4 != 0) {
        bring_together(random, pair);
    }
    return finished(random, pair);
}

/// A segment on a coarse lattice, with its midpoint as third corner, meets a triangle or segment on
/// a finer one: ends and crossings are exactly on edges and faces.
PosedPair segment_against(std::mt19937_64& random) {
    PosedPair pair{scaled(lattice_corners(random, 2), 2), lattice_corners(random, 3), {}};
    pair.a[2] = (pair.a[0] + pair.a[1]) / 2;
    if (random() % 4 == 0) {
        pair.b[2] = pair.b[random() % 2];
    }
    return finished(random, pair);
}

/// A point is nominally or exactly on a triangle, segment or point.
PosedPair point_against(std::mt19937_64& random) {
    PosedPair pair{{}, scaled(lattice_corners(random, 2), 4), {}};
    const double first = static_cast<double>(random() % 5);
    const double second = first + static_cast<double>(random() % 2);
    Vec3 point = pair.b[0] + first / 4 * (pair.b[1] - pair.b[0]) +
                 (second - first) / 4 * (pair.b[2] - pair.b[0]);
    if (random() % 3 == 0) {
        point = nudged(random, point);
    }
    pair.a = {point, point, point};
    if (random() % 5 == 0) {
        pair.b[2] = pair.b[1];
    }
    return finished(random, pair);
}

PosedPair nearly_touching_scaled(std::mt19937_64& random, double factor) {
    PosedPair pair{random_corners(random, 1), random_corners(random, 1), {}};
    bring_together(random, pair);
    if (random() % 2 == 0) {
        pair.b[0] = point_on(random, pair.a);
    }
    return shuffled(random, {scaled(pair.a, factor), scaled(pair.b, factor), {}});
}

Corners denormal_corners(std::mt19937_64& random) {
    return scaled(lattice_corners(random, 1 << 20), 0x1p-1074);
}

/// Makes triangles of a city's walls and roofs: integer millimetres, at six- and seven-digit
/// metres.
Corners utm_corners(std::mt19937_64& random) {
    Corners t;
    for (Vec3& corner : t) {
        const auto millimetres = [&](double base, std::uint64_t cells) {
            return (base + 2500.0 * static_cast<double>(random() % cells)) * 0.001;
        };
        corner.x() = millimetres(691604123, 4);
        corner.y() = millimetres(5334712456, 4);
        corner.z() = millimetres(519100, 3);
    }
    return t;
}

PosedPair far_features(std::mt19937_64& random) {
    PosedPair pair{
        scaled(lattice_corners(random, 3), 1e-3), scaled(lattice_corners(random, 3), 1e-3), {}};
    switch (random() % 3) {
    case 0: // Far away in the file itself.
        move_by(pair.a, Vec3(1e7, 1e7, 1e7));
        move_by(pair.b, Vec3(1e7, 1e7, 1e7));
        return finished(random, pair);
    case 1: // Moved far away by the poses.
        pair.poses.a = pair.poses.b = translation_pose(1e7, -1e7, 1e7);
        return pair;
    default: // Moved back by one pose.
        move_by(pair.b, Vec3(1e7, 1e7, 1e7));
        pair.poses.b = translation_pose(-1e7, -1e7, -1e7);
        return pair;
    }
}

PosedPair scales_apart(std::mt19937_64& random) {
    PosedPair pair{
        scaled(random_corners(random, 1), 1e6), scaled(random_corners(random, 1), 1e-6), {}};
    if (random() % 2 == 0) {
        bring_together(random, pair);
    } else {
        // Puts the small one around a corner or an edge of the large one.
        move_by(pair.b, pair.a[0] + (random() % 2 == 0 ? 0.0 : 0.5) * (pair.a[1] - pair.a[0]));
    }
    return finished(random, pair);
}

} // namespace

void add_extreme_makers(PairMakers& makers) {
    makers["slivers 1e6 to 1e12"] = [](auto& r) { return thin_against(r, sliver); };
    makers["needles 1e6 to 1e12"] = [](auto& r) { return thin_against(r, needle); };
    makers["degenerate to a segment"] = segment_against;
    makers["degenerate to a point"] = point_against;
    makers["tiny 1e-20"] = [](auto& r) { return nearly_touching_scaled(r, 1e-20); };
    makers["denormal, many steps"] = [](auto& r) {
        return PosedPair{denormal_corners(r), denormal_corners(r), {}};
    };
    makers["huge 2^400, nearly touching"] = [](auto& r) {
        return nearly_touching_scaled(r, 0x1p400);
    };
    makers["offset 1e7 with features of 1e-3"] = far_features;
    makers["walls in UTM coordinates"] = [](auto& r) {
        return finished(r, {utm_corners(r), utm_corners(r), {}});
    };
    makers["scales 1e-6 with 1e6"] = scales_apart;
}

} // namespace cd::tests
