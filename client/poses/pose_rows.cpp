#include "client/poses/pose_rows.hpp"

#include "client/spec/poses_spec.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace cd {

namespace {

constexpr double matrix_off_max = 1e-5;
constexpr double warn_above = 1e-9;
constexpr std::uint64_t rows_at_once = 4096;

Pose to_pose(std::span<const double> v, PoseLayout layout, double length_factor) {
    const auto length = [&](std::size_t i) { return length_factor * v[i]; };
    switch (layout) {
    case PoseLayout::Xyzw:
        return Pose::from_quaternion({v[6], v[3], v[4], v[5]}, {length(0), length(1), length(2)});
    case PoseLayout::Wxyz:
        return Pose::from_quaternion({v[3], v[4], v[5], v[6]}, {length(0), length(1), length(2)});
    case PoseLayout::Matrix44:
    case PoseLayout::Matrix34:
        break;
    }
    Mat3 rotation;
    Vec3 translation;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            rotation(row, column) = v[static_cast<std::size_t>(4 * row + column)];
        }
        translation[row] = length(static_cast<std::size_t>(4 * row + 3));
    }
    return Pose::from_matrix(rotation, translation);
}

bool is_quaternion(PoseLayout layout) {
    return layout == PoseLayout::Xyzw || layout == PoseLayout::Wxyz;
}

/// Returns how far a pose is from rigid: |norm - 1| of a quaternion, max|R'R - I| of a matrix.
/// Errors: BadInput for faults that no tolerance allows.
Result<double>
distance_from_rigid(std::span<const double> v, PoseLayout layout, double length_factor) {
    const auto bad = [](std::string detail) { return bad_input(std::move(detail)); };
    for (const double value : v) {
        if (!std::isfinite(value)) {
            return bad(fmt::format("the number {} is not finite", value));
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = v[is_quaternion(layout) ? i : 4 * i + 3];
        if (!std::isfinite(length_factor * length)) {
            return bad(fmt::format("the translation {} is too large in the job's unit", length));
        }
    }
    if (is_quaternion(layout)) {
        const double norm = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
        if (norm == 0) {
            return bad("the quaternion is zero");
        }
        return std::abs(norm - 1);
    }
    if (layout == PoseLayout::Matrix44 && !(v[12] == 0 && v[13] == 0 && v[14] == 0 && v[15] == 1)) {
        return bad(fmt::format(
            "the last row of the matrix is {} {} {} {}, not 0 0 0 1", v[12], v[13], v[14], v[15]));
    }
    const Mat3 rotation = to_pose(v, layout, 1).matrix();
    const double determinant = rotation.determinant();
    if (!(determinant > 0)) {
        return bad(fmt::format("the matrix mirrors: its determinant is {:.6g}", determinant));
    }
    return Mat3(rotation.transpose() * rotation - Mat3::Identity()).cwiseAbs().maxCoeff();
}

/// How far a pose may be from rigid unless the user says otherwise.
double allowed_off(PoseLayout layout) {
    return is_quaternion(layout) ? quaternion_off_max : matrix_off_max;
}

std::string describe(PoseLayout layout, double off, double allowed) {
    const char* what = is_quaternion(layout) ? "the quaternion's norm is off 1 by"
                                             : "max |R'R - I| of the matrix is";
    return fmt::format("{} {:.3g}, more than {:.3g}", what, off, allowed);
}

/// True if all numbers of a pose are NaN, and the table says that its body is then absent.
bool is_absent(const PoseTable& table, std::span<const double> numbers) {
    return table.nan_is_absent &&
           std::ranges::all_of(numbers, [](double number) { return std::isnan(number); });
}

class TableSource final : public PoseSource {
  public:
    explicit TableSource(PoseTable table) : table_(std::move(table)) {}

    [[nodiscard]] std::uint64_t count() const override { return table_.rows->row_count(); }

    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override {
        const std::lock_guard lock(mutex_);
        const auto poses = CD_TRY(poses_of_rows(table_, first, count));
        const std::size_t each = table_.poses_each();
        std::vector<Scenario> scenarios(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            scenarios[i].index = first + i;
            if (each == 2) {
                scenarios[i].poses.a = *poses[2 * i];
            }
            scenarios[i].poses.b = *poses[each * i + each - 1];
        }
        return scenarios;
    }

    [[nodiscard]] std::string place_of(std::uint64_t scenario) const override {
        const std::size_t each = table_.poses_each();
        const std::vector<std::uint64_t>& lines = table_.lines;
        if (lines.empty()) {
            return fmt::format("row {}", scenario);
        }
        return each == 1
                   ? fmt::format("line {}", lines[scenario])
                   : fmt::format("lines {} and {}", lines[2 * scenario], lines[2 * scenario + 1]);
    }

  private:
    PoseTable table_;
    std::mutex mutex_; ///< Guards the position in the file.
};

} // namespace

std::size_t numbers_of(PoseLayout layout) {
    switch (layout) {
    case PoseLayout::Matrix44:
        return 16;
    case PoseLayout::Matrix34:
        return 12;
    case PoseLayout::Xyzw:
    case PoseLayout::Wxyz:
        break;
    }
    return 7;
}

Result<Pose> checked_pose(std::span<const double> numbers, PoseLayout layout) {
    const double off = CD_TRY(distance_from_rigid(numbers, layout, 1));
    const double allowed = allowed_off(layout);
    if (!(off <= allowed)) {
        return bad_input(describe(layout, off, allowed));
    }
    return to_pose(numbers, layout, 1);
}

std::string place_of_pose(const PoseTable& table, std::uint64_t pose) {
    if (pose < table.lines.size()) {
        return fmt::format("line {}", table.lines[pose]);
    }
    const std::size_t each = table.poses_each();
    return table.bodies.empty()
               ? fmt::format("row {}", pose)
               : fmt::format("row {}, body {}", pose / each, table.bodies[pose % each]);
}

Result<RigidityReport> check_rows(const PoseTable& table, std::optional<double> rigid_tolerance) {
    const std::size_t size = numbers_of(table.layout);
    const std::size_t poses = table.poses_each();
    const double allowed = rigid_tolerance.value_or(allowed_off(table.layout));
    RigidityReport report;
    for (std::uint64_t first = 0; first < table.rows->row_count(); first += rows_at_once) {
        const std::uint64_t count = std::min(rows_at_once, table.rows->row_count() - first);
        const auto numbers = CD_TRY(table.rows->read(first, count));
        for (std::uint64_t i = 0; i < count * poses; ++i) {
            const std::uint64_t pose = first * poses + i;
            const auto given = std::span(numbers).subspan(i * size, size);
            if (is_absent(table, given)) {
                continue;
            }
            const auto off = distance_from_rigid(given, table.layout, table.length_factor);
            if (off && table.from_angles) {
                continue;
            }
            if (!off || !(off.value() <= allowed)) {
                return bad_input(
                    fmt::format("{}: {}",
                                place_of_pose(table, pose),
                                off ? describe(table.layout, off.value(), allowed) +
                                          "; rigid_tolerance of [poses] (--rigid-tolerance) "
                                          "allows more"
                                    : off.error().detail));
            }
            if (off.value() > warn_above) {
                ++report.off;
                if (off.value() > report.worst) {
                    report.worst = off.value();
                    report.worst_pose = pose;
                }
            }
        }
    }
    return report;
}

std::vector<std::string> both_bodies() {
    return {"a", "b"};
}

Result<std::vector<std::optional<Pose>>>
poses_of_rows(const PoseTable& table, std::uint64_t first, std::uint64_t count) {
    const auto numbers = CD_TRY(table.rows->read(first, count));
    const std::size_t size = numbers_of(table.layout);
    std::vector<std::optional<Pose>> poses;
    poses.reserve(count * table.poses_each());
    for (std::size_t i = 0; i < numbers.size(); i += size) {
        const auto given = std::span(numbers).subspan(i, size);
        if (is_absent(table, given)) {
            poses.emplace_back();
            continue;
        }
        const auto off = distance_from_rigid(given, table.layout, table.length_factor);
        if (!off) {
            const std::uint64_t pose = first * table.poses_each() + i / size;
            return bad_input(fmt::format(
                "{}: {}: {}", table.name, place_of_pose(table, pose), off.error().detail));
        }
        poses.emplace_back(to_pose(given, table.layout, table.length_factor));
    }
    return poses;
}

std::unique_ptr<PoseSource> make_table_source(PoseTable table) {
    CD_CHECK(table.poses_each() <= 2);
    CD_CHECK(!table.nan_is_absent);
    return std::make_unique<TableSource>(std::move(table));
}

} // namespace cd
