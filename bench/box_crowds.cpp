#include "bench/box_crowds.hpp"

#include <cmath>
#include <random>

namespace cd::bench {

namespace {

double uniform(std::mt19937_64& random, double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(random() >> 11);
}

Aabb box_of(const Vec3& size) {
    Aabb box;
    box.add(-0.5 * size);
    box.add(0.5 * size);
    return box;
}

} // namespace

std::vector<PosedBox> make_town(std::size_t count) {
    std::mt19937_64 random(1);
    const double side = 10 * std::sqrt(static_cast<double>(count));
    std::vector<PosedBox> cars;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = (random() % 2 == 0 ? 0 : 0.7071) + uniform(random, -0.05, 0.05);
        cars.push_back(
            {box_of(Vec3(4.5, 1.8, 1.5)),
             Pose::from_quaternion({std::sqrt(1 - turn * turn), 0, 0, turn},
                                   Vec3(uniform(random, 0, side), uniform(random, 0, side), 0))});
    }
    return cars;
}

std::vector<PosedBox> make_assembly(std::size_t count) {
    std::mt19937_64 random(2);
    const double side = 0.1 * std::cbrt(static_cast<double>(count));
    std::vector<PosedBox> parts;
    for (std::size_t i = 0; i < count; ++i) {
        const auto size = [&] { return 0.01 * std::pow(30, uniform(random, 0, 1)); };
        const auto place = [&] { return uniform(random, 0, side); };
        const auto turn = [&] { return uniform(random, -1, 1); };
        parts.push_back({box_of(Vec3(size(), size(), size())),
                         Pose::from_quaternion({turn(), turn(), turn(), turn()},
                                               Vec3(place(), place(), place()))});
    }
    return parts;
}

std::vector<std::vector<Pose>>
moving_poses(const std::vector<PosedBox>& boxes, std::size_t steps, const Vec3& move, double turn) {
    std::mt19937_64 random(3);
    std::vector<std::vector<Pose>> poses(steps);
    for (const PosedBox& box : boxes) {
        const auto share = [&] { return uniform(random, -1, 1); };
        const Vec3 velocity = move.cwiseProduct(Vec3(share(), share(), share()));
        const double half_turn = 0.5 * turn * share();
        for (std::size_t step = 0; step < steps; ++step) {
            const auto time = static_cast<double>(step);
            const Quaternion turned{std::cos(time * half_turn), 0, 0, std::sin(time * half_turn)};
            poses[step].push_back(Pose::from_quaternion(turned * box.pose.quaternion(),
                                                        box.pose.translation() + time * velocity));
        }
    }
    return poses;
}

} // namespace cd::bench
