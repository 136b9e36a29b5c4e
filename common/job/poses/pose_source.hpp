// The source of a job's scenarios, read in ranges so that they are never all in memory.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/random_poses.hpp"
#include "common/job/scenario.hpp"
#include "common/tree/obb_tree.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cd {

struct Grid;

/// An interface to the scenarios of a job by index. Implementations: files (client), generators,
/// the master's spool.
class PoseSource {
  public:
    PoseSource() = default;
    PoseSource(const PoseSource&) = delete;
    PoseSource& operator=(const PoseSource&) = delete;
    virtual ~PoseSource() = default;

    [[nodiscard]] virtual std::uint64_t count() const = 0;
    /// Reads scenarios [first, first + count), which exist. The result depends on the arguments
    /// alone. Errors: Io, BadInput naming the row.
    [[nodiscard]] virtual Result<std::vector<Scenario>> read(std::uint64_t first,
                                                             std::uint64_t count) = 0;
    /// Returns the grid that gives the scenarios' poses; null if the poses are no grid.
    [[nodiscard]] virtual const Grid* grid() const { return nullptr; }
    /// Names the place of an existing scenario's poses, for messages: "line 2" or "row 0" of a
    /// file, else "pose 0".
    [[nodiscard]] virtual std::string place_of(std::uint64_t scenario) const {
        return "pose " + std::to_string(scenario);
    }
};

/// `count` evenly spaced values from `first` to `last`, both included; a count of 1 gives `first`.
struct GridAxis {
    double first = 0;
    double last = 0;
    std::uint64_t count = 1;

    /// Returns value number `number`: the ends exactly, and between them
    /// first + (last - first) * number / (count - 1), each operation rounded in the order of C++.
    [[nodiscard]] double at(std::uint64_t number) const;

    friend bool operator==(const GridAxis&, const GridAxis&) = default;
};

/// A grid of poses over positions and Euler angles. In the order x, y, z, roll, pitch, yaw, the
/// first varies slowest and the last fastest. Jobs send this description. Its angles are already
/// quaternions, so that evaluating a grid only takes + - * /.
struct Grid {
    std::array<GridAxis, 3> position; ///< x, y, z
    /// Rotations about x (roll), y (pitch), z (yaw); an empty list does not rotate.
    std::array<std::vector<Quaternion>, 3> rotation;

    [[nodiscard]] std::uint64_t
    count() const; ///< Number of poses; UINT64_MAX if it would overflow.
    /// Returns B's pose number `number`, below `count()`, always in quaternion form.
    [[nodiscard]] Pose at(std::uint64_t number) const;

    friend bool operator==(const Grid&, const Grid&) = default;
};

/// Returns the quaternions of evenly spaced angles in degrees about axis 0, 1 or 2. Multiples of 90
/// degrees are exact. The client calls this when it reads the job, so that hosts on which sin and
/// cos differ run equal poses.
[[nodiscard]] std::vector<Quaternion> rotation_axis(const GridAxis& degrees, int axis);

/// Returns the rotation by three angles in degrees: first roll about x, then pitch about y, then
/// yaw about z (R = Rz Ry Rx).
[[nodiscard]] Quaternion quaternion_from_euler(double roll_deg, double pitch_deg, double yaw_deg);

/// Returns scenario number `number` of a grid: B has the grid's pose, A the identity.
[[nodiscard]] Scenario scenario_on(const Grid& grid, std::uint64_t number);
[[nodiscard]] std::unique_ptr<PoseSource> make_grid_source(Grid grid);

[[nodiscard]] Bytes encode_grid(const Grid& grid);
/// Decodes a grid. The bytes are untrusted. On success every pose has finite numbers, quaternions
/// have lengths between 1/2 and 2, and the count is in [1, `limits::scenarios_max`]. Errors:
/// BadFrame.
[[nodiscard]] Result<Grid> decode_grid(std::span<const std::byte> bytes);

/// Makes random scenarios (random_poses.hpp), equal on every host and for any number of threads.
/// B's poses are quaternions, A's the identity. A scenario depends on the bodies, its index, the
/// seed and the penetration bounds alone, not on `count`.
///
/// B approaches the centre of A's box along a straight line. The first collision is at the first of
/// 32 steps at which the bodies collide, refined to about 1/32,000 of the way. If a line reaches
/// A's centre without a collision, another direction and orientation are drawn; after 64 such lines
/// B stays at the centre.
[[nodiscard]] std::vector<Scenario>
make_random_poses(const RandomPoses& options, const ObbTree& a, const ObbTree& b, ThreadPool& pool);

/// Makes a source of scenarios that are held in memory.
[[nodiscard]] std::unique_ptr<PoseSource> make_list_source(std::vector<Scenario> scenarios);

} // namespace cd
