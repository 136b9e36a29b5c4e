#include "tests/support/exact_world.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cd::tests {

namespace {

/// A double is mantissa * 2^exponent, the mantissa odd or 0.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = std::numeric_limits<int>::max();
};

Dyadic dyadic(double x) {
    if (x == 0) {
        return {};
    }
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
    return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

/// Each number is an integer times 2^exponent.
struct Scaled {
    std::vector<Integer> numbers;
    int exponent = 0;
};

Integer shifted(const Integer& number, int bits) {
    Integer result;
    mpz_mul_2exp(result.get_mpz_t(), number.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
    return result;
}

Scaled scaled(std::span<const double> doubles) {
    std::vector<Dyadic> parts(doubles.size());
    std::transform(doubles.begin(), doubles.end(), parts.begin(), dyadic);
    int least = std::numeric_limits<int>::max();
    for (const Dyadic& part : parts) {
        least = std::min(least, part.exponent);
    }
    Scaled result{std::vector<Integer>(doubles.size()), 0};
    if (least == std::numeric_limits<int>::max()) {
        return result;
    }
    result.exponent = least;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].mantissa != 0) {
            result.numbers[i] = static_cast<long>(parts[i].mantissa);
            mpz_mul_2exp(result.numbers[i].get_mpz_t(),
                         result.numbers[i].get_mpz_t(),
                         static_cast<mp_bitcnt_t>(parts[i].exponent - least));
        }
    }
    return result;
}

/// R = entries * 2^exponent / denominator, row by row.
struct Rotation {
    std::vector<Integer> entries;
    int exponent = 0;
    Integer denominator = 1;
};

Rotation rotation_of(const Pose& pose) {
    if (pose.kind() == Pose::Kind::Matrix) {
        std::array<double, 9> rows{};
        for (int i = 0; i < 9; ++i) {
            rows[static_cast<std::size_t>(i)] = pose.matrix()(i / 3, i % 3);
        }
        Scaled matrix = scaled(rows);
        return {std::move(matrix.numbers), matrix.exponent, 1};
    }
    const Quaternion& q = pose.quaternion();
    // Numerators and denominator have the same degree in q, so its scale cancels.
    const std::vector<Integer> n = scaled(std::array{q.w, q.x, q.y, q.z}).numbers;
    const Integer& w = n[0];
    const Integer& x = n[1];
    const Integer& y = n[2];
    const Integer& z = n[3];
    Rotation result;
    const auto add = [&](const Integer& entry) { result.entries.push_back(entry); };
    add(w * w + x * x - y * y - z * z);
    add(2 * (x * y - w * z));
    add(2 * (x * z + w * y));
    add(2 * (x * y + w * z));
    add(w * w - x * x + y * y - z * z);
    add(2 * (y * z - w * x));
    add(2 * (x * z - w * y));
    add(2 * (y * z + w * x));
    add(w * w - x * x - y * y + z * z);
    result.denominator = w * w + x * x + y * y + z * z;
    return result;
}

/// World points are points * 2^exponent / denominator.
struct PosedPoints {
    std::vector<ExactPoint> points;
    int exponent = 0;
    Integer denominator;
};

PosedPoints posed(std::span<const Vec3> vertices, const Pose& pose) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    const Scaled local = scaled({vertices.data()->data(), 3 * vertices.size()});
    const Scaled offset = scaled({pose.translation().data(), 3});
    Rotation rotation = rotation_of(pose);

    PosedPoints result;
    const int turned_exponent = local.exponent + rotation.exponent;
    result.exponent = std::min(turned_exponent, offset.exponent);
    result.denominator = std::move(rotation.denominator);
    for (Integer& entry : rotation.entries) {
        entry = shifted(entry, turned_exponent - result.exponent);
    }
    std::array<Integer, 3> moved;
    for (std::size_t k = 0; k < 3; ++k) {
        moved[k] = shifted(offset.numbers[k], offset.exponent - result.exponent);
        moved[k] *= result.denominator;
    }
    result.points.resize(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            Integer& to = result.points[i][k];
            to = moved[k];
            for (std::size_t j = 0; j < 3; ++j) {
                to += rotation.entries[3 * k + j] * local.numbers[3 * i + j];
            }
        }
    }
    return result;
}

void multiply(std::vector<ExactPoint>& points, const Integer& factor) {
    if (factor == 1) {
        return;
    }
    for (ExactPoint& point : points) {
        for (Integer& coordinate : point) {
            coordinate *= factor;
        }
    }
}

} // namespace

ExactWorld exact_world(std::span<const Vec3> a, std::span<const Vec3> b, const PosePair& poses) {
    PosedPoints in_a = posed(a, poses.a);
    PosedPoints in_b = posed(b, poses.b);
    const Integer common = gcd(in_a.denominator, in_b.denominator);
    const int least = std::min(in_a.exponent, in_b.exponent);
    multiply(in_a.points, shifted(in_b.denominator / common, in_a.exponent - least));
    multiply(in_b.points, shifted(in_a.denominator / common, in_b.exponent - least));
    return {std::move(in_a.points),
            std::move(in_b.points),
            least,
            in_a.denominator / common * in_b.denominator};
}

std::vector<ExactTriangle> triangles_of(const Mesh& mesh, const std::vector<ExactPoint>& points) {
    std::vector<ExactTriangle> triangles;
    for (const Triangle& t : mesh.triangles()) {
        triangles.push_back({points[t[0]], points[t[1]], points[t[2]]});
    }
    return triangles;
}

ExactPoint minus(const ExactPoint& l, const ExactPoint& r) {
    return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

Integer dot(const ExactPoint& l, const ExactPoint& r) {
    return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

ExactPoint cross(const ExactPoint& l, const ExactPoint& r) {
    return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

ExactPoint normal_of(const ExactTriangle& t) {
    return cross(minus(t[1], t[0]), minus(t[2], t[0]));
}

bool is_zero(const ExactPoint& p) {
    return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

} // namespace cd::tests
