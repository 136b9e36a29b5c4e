#include "common/job/poses/pose_source.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cd {

namespace {

constexpr std::uint8_t grid_version = 1;

std::uint64_t product(std::uint64_t left, std::uint64_t right) {
    std::uint64_t value = 0;
    return __builtin_mul_overflow(left, right, &value) ? UINT64_MAX : value;
}

std::uint64_t turns_in(const std::vector<Quaternion>& rotation) {
    return rotation.empty() ? 1 : rotation.size();
}

/// Returns the quaternion of a rotation about an axis; exact for multiples of 90 degrees.
Quaternion turn(double degrees, int axis) {
    CD_CHECK(axis >= 0);
    CD_CHECK(axis < 3);
    const double reduced = std::fmod(degrees, 360.0); // fmod is exact.
    double w = 1;
    double sine = 0;
    if (reduced == 90 || reduced == -270) {
        sine = 1;
    } else if (reduced == -90 || reduced == 270) {
        sine = -1;
    } else if (reduced == 180 || reduced == -180) {
        w = 0;
        sine = 1;
    } else if (reduced != 0) {
        const double half = reduced * std::numbers::pi / 360.0;
        w = std::cos(half);
        sine = std::sin(half);
    }
    Quaternion q{w, 0, 0, 0};
    (axis == 0 ? q.x : axis == 1 ? q.y : q.z) = sine;
    return q;
}

class ListSource : public PoseSource {
  public:
    explicit ListSource(std::vector<Scenario> scenarios) : scenarios_(std::move(scenarios)) {}

    std::uint64_t count() const override { return scenarios_.size(); }

    Result<std::vector<Scenario>> read(std::uint64_t first, std::uint64_t count) override {
        CD_CHECK(first <= scenarios_.size());
        CD_CHECK(count <= scenarios_.size() - first);
        const auto run = std::span<const Scenario>(scenarios_).subspan(first, count);
        return std::vector<Scenario>(run.begin(), run.end());
    }

  private:
    std::vector<Scenario> scenarios_;
};

/// Goes through the poses of a grid in order, without a division for each.
class GridWalk {
  public:
    GridWalk(const Grid& grid, std::uint64_t number) : grid_(grid) {
        for (std::size_t i = 3; i-- > 0;) {
            turn_[i] = number % turns_in(grid.rotation[i]);
            number /= turns_in(grid.rotation[i]);
        }
        for (std::size_t i = 3; i-- > 0;) {
            place_[i] = number % grid.position[i].count;
            number /= grid.position[i].count;
        }
        move();
    }

    [[nodiscard]] Pose pose() const {
        Quaternion turned;
        for (std::size_t i = 3; i-- > 0;) { // Yaw is applied last.
            if (!grid_.rotation[i].empty()) {
                turned = turned * grid_.rotation[i][turn_[i]];
            }
        }
        return Pose::from_quaternion(turned, translation_);
    }

    /// Goes to the next pose, and from the last to the first.
    void next() {
        for (std::size_t i = 3; i-- > 0;) { // Yaw varies fastest.
            if (++turn_[i] < turns_in(grid_.rotation[i])) {
                return;
            }
            turn_[i] = 0;
        }
        for (std::size_t i = 3; i-- > 0;) {
            if (++place_[i] < grid_.position[i].count) {
                break;
            }
            place_[i] = 0;
        }
        move();
    }

  private:
    void move() {
        for (std::size_t i = 0; i < 3; ++i) {
            translation_[static_cast<Eigen::Index>(i)] = grid_.position[i].at(place_[i]);
        }
    }

    const Grid& grid_;
    std::array<std::uint64_t, 3> turn_{};  ///< Numbers of the roll, pitch and yaw angle.
    std::array<std::uint64_t, 3> place_{}; ///< Numbers on the axes x, y and z.
    Vec3 translation_;
};

class GridSource : public PoseSource {
  public:
    explicit GridSource(Grid grid) : grid_(std::move(grid)), count_(grid_.count()) {}

    std::uint64_t count() const override { return count_; }

    Result<std::vector<Scenario>> read(std::uint64_t first, std::uint64_t count) override {
        CD_CHECK(first <= count_);
        CD_CHECK(count <= count_ - first);
        std::vector<Scenario> scenarios(count);
        GridWalk walk(grid_, first);
        for (std::uint64_t i = 0; i < count; ++i) {
            scenarios[i].index = first + i;
            scenarios[i].poses.b = walk.pose();
            walk.next();
        }
        return scenarios;
    }

    const Grid* grid() const override { return &grid_; }

  private:
    Grid grid_;
    std::uint64_t count_;
};

bool is_valid(const Grid& grid) {
    for (const GridAxis& axis : grid.position) {
        // The largest intermediate value of `GridAxis::at`.
        const double reach = (axis.last - axis.first) * static_cast<double>(axis.count);
        if (!std::isfinite(axis.first) || !std::isfinite(axis.last) || !std::isfinite(reach)) {
            return false;
        }
    }
    for (const std::vector<Quaternion>& rotation : grid.rotation) {
        for (const Quaternion& q : rotation) {
            // Products of three such quaternions are finite and nonzero. NaN fails the test.
            const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
            if (!(square > 0.25 && square < 4)) {
                return false;
            }
        }
    }
    return grid.count() >= 1 && grid.count() <= limits::scenarios_max;
}

} // namespace

double GridAxis::at(std::uint64_t number) const {
    CD_CHECK(number < count);
    if (number == 0) {
        return first;
    }
    if (number == count - 1) {
        return last;
    }
    return first + (last - first) * static_cast<double>(number) / static_cast<double>(count - 1);
}

std::uint64_t Grid::count() const {
    std::uint64_t count = 1;
    for (int i = 0; i < 3; ++i) {
        // A count of 0 gives 0, even if an earlier product has saturated.
        if (position[static_cast<std::size_t>(i)].count == 0) {
            return 0;
        }
        count = product(count, position[static_cast<std::size_t>(i)].count);
        count = product(count, turns_in(rotation[static_cast<std::size_t>(i)]));
    }
    return count;
}

Pose Grid::at(std::uint64_t number) const {
    CD_CHECK(number < count());
    return GridWalk(*this, number).pose();
}

Scenario scenario_on(const Grid& grid, std::uint64_t number) {
    Scenario scenario;
    scenario.index = number;
    scenario.poses.b = grid.at(number);
    return scenario;
}

std::vector<Quaternion> rotation_axis(const GridAxis& degrees, int axis) {
    std::vector<Quaternion> turns;
    turns.reserve(degrees.count);
    for (std::uint64_t i = 0; i < degrees.count; ++i) {
        turns.push_back(turn(degrees.at(i), axis));
    }
    return turns;
}

Quaternion quaternion_from_euler(double roll_deg, double pitch_deg, double yaw_deg) {
    return turn(yaw_deg, 2) * turn(pitch_deg, 1) * turn(roll_deg, 0);
}

std::unique_ptr<PoseSource> make_grid_source(Grid grid) {
    return std::make_unique<GridSource>(std::move(grid));
}

std::unique_ptr<PoseSource> make_list_source(std::vector<Scenario> scenarios) {
    return std::make_unique<ListSource>(std::move(scenarios));
}

Bytes encode_grid(const Grid& grid) {
    ByteWriter out;
    out.put(grid_version);
    for (const GridAxis& axis : grid.position) {
        out.put(axis.first);
        out.put(axis.last);
        out.put(axis.count);
    }
    for (const std::vector<Quaternion>& rotation : grid.rotation) {
        out.put(static_cast<std::uint64_t>(rotation.size()));
        for (const Quaternion& q : rotation) {
            out.put_array(std::span<const double>(std::array<double, 4>{q.w, q.x, q.y, q.z}));
        }
    }
    return out.take();
}

Result<Grid> decode_grid(std::span<const std::byte> bytes) {
    ByteReader in(bytes);
    if (in.get<std::uint8_t>() != grid_version) {
        return Error{ErrorCode::BadFrame, "grid: unknown version"};
    }
    Grid grid;
    for (GridAxis& axis : grid.position) {
        axis.first = in.get<double>();
        axis.last = in.get<double>();
        axis.count = in.get<std::uint64_t>();
    }
    for (std::vector<Quaternion>& rotation : grid.rotation) {
        const auto turns = in.get<std::uint64_t>();
        const auto values = in.get_array<double>(turns <= UINT64_MAX / 4 ? 4 * turns : UINT64_MAX);
        for (std::size_t i = 0; i < values.size(); i += 4) {
            rotation.push_back({values[i], values[i + 1], values[i + 2], values[i + 3]});
        }
    }
    if (!in.complete()) {
        return Error{ErrorCode::BadFrame, "grid: cut short or bytes left over"};
    }
    if (!is_valid(grid)) {
        return Error{ErrorCode::BadFrame,
                     "grid: numbers that are not finite, turns that are none, or too many poses"};
    }
    return grid;
}

} // namespace cd
