#include "client/scene/scene_steps.hpp"

#include "client/poses/pose_file.hpp"
#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace cd {

namespace {

/// The file of an entry's own poses, and the bodies that have them.
struct OwnPoses {
    std::shared_ptr<PoseSource> source;
    std::vector<std::uint32_t> bodies;
};

/// The poses that fixed bodies have at every step, and the sources of all others.
struct PoseSources {
    PosesOfStep fixed; ///< By body; nothing for bodies that move.
    std::vector<OwnPoses> own;
    std::optional<PoseTable> table;          ///< The rows of [poses].
    std::vector<std::uint32_t> table_bodies; ///< The body of each pose in a row of `table`.
    std::shared_ptr<const RoadTraffic> traffic = nullptr; ///< Null: there are no vehicles.
    std::vector<std::uint32_t> vehicle_bodies = {};       ///< The body of each vehicle.
    std::uint64_t steps = 1;
    std::vector<double> times = {};
};

class FileSteps final : public StepPoses {
  public:
    explicit FileSteps(PoseSources sources) : sources_(std::move(sources)) {}

    [[nodiscard]] std::uint64_t steps() const override { return sources_.steps; }
    [[nodiscard]] std::vector<double> times() const override { return sources_.times; }

    [[nodiscard]] Result<PosesOfStep> read(std::uint64_t step) override {
        CD_CHECK(step < sources_.steps);
        PosesOfStep poses = sources_.fixed;
        for (const OwnPoses& own : sources_.own) {
            const auto read = CD_TRY(own.source->read(step, 1));
            for (const std::uint32_t body : own.bodies) {
                poses[body] = read.front().poses.b;
            }
        }
        if (sources_.table) {
            const auto row = CD_TRY(poses_of_rows(*sources_.table, step, 1));
            for (std::size_t i = 0; i < row.size(); ++i) {
                poses[sources_.table_bodies[i]] = row[i];
            }
        }
        if (sources_.traffic) {
            for (const TrafficRow& row : sources_.traffic->rows_of(step)) {
                poses[sources_.vehicle_bodies[row.vehicle]] =
                    Pose::from_quaternion(row.rotation, row.position);
            }
        }
        return poses;
    }

  private:
    PoseSources sources_;
};

/// Multiplies all lengths.
void scale(std::vector<PoseRates>& rates, double factor) {
    for (PoseRates& each : rates) {
        each.velocity *= factor;
        each.acceleration *= factor;
    }
}

/// A file that gives poses for each step, for messages.
struct StepsOfFile {
    std::string name;
    std::uint64_t steps = 0;
    std::vector<double> times;
};

class StepsOpening {
  public:
    StepsOpening(const SceneSpec& spec,
                 const SceneBodies& scene,
                 const std::filesystem::path& job_file,
                 std::shared_ptr<const RoadTraffic> traffic)
        : spec_(spec), scene_(scene), job_file_(job_file), has_pose_(scene.bodies.size(), false) {
        sources_.fixed.resize(scene.bodies.size());
        sources_.traffic = std::move(traffic);
        for (std::uint32_t body = 0; body < scene.bodies.size(); ++body) {
            numbers_.emplace(scene.bodies[body].name, body);
        }
    }

    Result<OpenedSteps> run() {
        take_vehicles();
        CD_TRY(open_table());
        for (std::uint32_t entry = 0; entry < spec_.bodies.size(); ++entry) {
            CD_TRY(open_entry(entry));
        }
        for (std::uint32_t body = 0; body < scene_.bodies.size(); ++body) {
            CD_TRY(check_body(body));
        }
        CD_TRY(check_files());
        for (const auto& pose : sources_.fixed) {
            opened_.are_fixed.push_back(pose.has_value());
        }
        opened_.poses = std::make_unique<FileSteps>(std::move(sources_));
        return std::move(opened_);
    }

  private:
    [[nodiscard]] Error problem_of(std::uint32_t entry, const std::string& what) const {
        const SceneBodySpec& spec = spec_.bodies[entry];
        return error_in_job(job_file_, spec.line, "[bodies] " + spec.name + ": " + what);
    }

    /// Finds the bodies of the vehicles, which `expand_bodies` made.
    void take_vehicles() {
        if (!sources_.traffic) {
            return;
        }
        for (const TrafficVehicle& vehicle : sources_.traffic->vehicles) {
            const std::uint32_t body = numbers_.at(vehicle.id);
            sources_.vehicle_bodies.push_back(body);
            has_pose_[body] = true;
        }
        files_.push_back(
            {sources_.traffic->name, sources_.traffic->times.size(), sources_.traffic->times});
        add_warnings(sources_.traffic->warnings);
    }

    /// Opens [poses], and finds the bodies that have rows there.
    Status open_table() {
        if (!spec_.poses) {
            return Done{};
        }
        auto opened = CD_TRY(open_scene_poses(*spec_.poses));
        std::vector<std::string_view> names;
        for (const NamedBody& body : scene_.bodies) {
            names.push_back(body.name);
        }
        const PoseTable& table = opened.table;
        for (std::size_t i = 0; i < table.bodies.size(); ++i) {
            const auto found = numbers_.find(table.bodies[i]);
            if (found == numbers_.end()) {
                return bad_input(table.name + ": " + place_of_pose(table, i) + ": no body of " +
                                 "[bodies] is called \"" + table.bodies[i] + "\"" +
                                 suggestion(table.bodies[i], names));
            }
            sources_.table_bodies.push_back(found->second);
            has_pose_[found->second] = true;
        }
        files_.push_back({table.name, table.rows->row_count(), table.labels.times});
        opened_.zeros = table.zeros;
        add_warnings(opened.warnings);
        add_table_rates(opened.table);
        sources_.table = std::move(opened.table);
        return Done{};
    }

    /// Takes the velocities of the bodies in [poses], if it has them.
    void add_table_rates(PoseTable& table) {
        if (table.rates.empty()) {
            return;
        }
        StepRates rates;
        for (std::size_t column = 0; column < sources_.table_bodies.size(); ++column) {
            rates.bodies.push_back({sources_.table_bodies[column], column});
        }
        rates.columns = table.bodies.size();
        rates.rates = std::exchange(table.rates, {});
        scale(rates.rates, table.length_factor);
        rates.name = [name = table.name, lines = table.lines, columns = rates.columns](
                         std::uint64_t step, std::size_t column) {
            return name + ": line " + std::to_string(lines[step * columns + column]);
        };
        opened_.rates.push_back(std::move(rates));
    }

    /// Opens the poses that an entry of [bodies] gives.
    Status open_entry(std::uint32_t entry) {
        const SceneBodySpec& spec = spec_.bodies[entry];
        if (!spec.pose && !spec.poses) {
            return Done{};
        }
        std::vector<std::uint32_t> bodies;
        for (std::uint32_t body = 0; body < scene_.bodies.size(); ++body) {
            if (scene_.bodies[body].entry != entry) {
                continue;
            }
            if (has_pose_[body]) {
                return problem_of(entry,
                                  "\"" + scene_.bodies[body].name +
                                      "\" has a pose here, and rows in " + files_.front().name +
                                      "; leave one of them out");
            }
            has_pose_[body] = true;
            bodies.push_back(body);
            sources_.fixed[body] = spec.pose;
        }
        return spec.poses ? open_own(*spec.poses, std::move(bodies)) : Status(Done{});
    }

    Status open_own(const PoseFileSpec& file, std::vector<std::uint32_t> bodies) {
        auto opened = CD_TRY(open_pose_file(file));
        CD_TRY(within(file.path.string() + ": ", check_times(opened)));
        files_.push_back({file.path.string(), opened.source->count(), opened.labels.times});
        add_warnings(opened.warnings);
        const std::shared_ptr<PoseSource> source = std::move(opened.source);
        if (!opened.rates.empty()) {
            StepRates rates;
            for (const std::uint32_t body : bodies) {
                rates.bodies.push_back({body, 0});
            }
            rates.rates = std::move(opened.rates);
            rates.name = [name = file.path.string(), source](std::uint64_t step, std::size_t) {
                return name + ": " + source->place_of(step);
            };
            opened_.rates.push_back(std::move(rates));
        }
        sources_.own.push_back({source, std::move(bodies)});
        return Done{};
    }

    /// Checks that the times of a body's own poses rise.
    static Status check_times(const OpenedPoses& opened) {
        const std::vector<double>& times = opened.labels.times;
        for (std::size_t row = 1; row < times.size(); ++row) {
            if (!(times[row - 1] < times[row])) {
                return bad_input(opened.source->place_of(row) + ": the time " +
                                 exact_text(times[row]) + " is not after " +
                                 exact_text(times[row - 1]) + " of " +
                                 opened.source->place_of(row - 1));
            }
        }
        return Done{};
    }

    /// Puts parts without a pose at the identity. Errors: BadInput for another body without one.
    Status check_body(std::uint32_t body) {
        if (has_pose_[body]) {
            return Done{};
        }
        const std::uint32_t entry = scene_.bodies[body].entry;
        if (spec_.bodies[entry].is_split) {
            sources_.fixed[body] = Pose();
            return Done{};
        }
        return problem_of(
            entry,
            "\"" + scene_.bodies[body].name +
                "\" has no pose; give it rows in [poses], poses = \"FILE\" with a pose "
                "for each step, or, where it stands still, pose = [x, y, z, qx, qy, "
                "qz, qw] and quat_order = \"xyzw\"");
    }

    /// Checks that all files have the same steps, and sets their number and times.
    Status check_files() {
        const StepsOfFile* timed = nullptr;
        for (const StepsOfFile& file : files_) {
            if (file.steps != files_.front().steps) {
                return bad_input(file.name + " has poses for " + counted(file.steps, "step") +
                                 ", and " + files_.front().name + " for " +
                                 grouped(files_.front().steps) +
                                 "; each body that moves needs a pose for each step");
            }
            if (file.times.empty()) {
                continue;
            }
            if (timed != nullptr && timed->times != file.times) {
                return bad_input("the times (t) in " + file.name + " differ from those in " +
                                 timed->name + "; a step has one time for all bodies");
            }
            timed = timed == nullptr ? &file : timed;
        }
        sources_.steps = files_.empty() ? 1 : files_.front().steps;
        sources_.times = timed != nullptr ? timed->times : std::vector<double>();
        return Done{};
    }

    void add_warnings(const std::vector<std::string>& warnings) {
        opened_.warnings.insert(opened_.warnings.end(), warnings.begin(), warnings.end());
    }

    const SceneSpec& spec_;
    const SceneBodies& scene_;
    const std::filesystem::path& job_file_;
    std::map<std::string_view, std::uint32_t> numbers_; ///< The index of each body's name.
    std::vector<bool> has_pose_; ///< For each body, whether a source of its poses is known.
    PoseSources sources_;
    std::vector<StepsOfFile> files_;
    OpenedSteps opened_;
};

} // namespace

Result<OpenedSteps> open_steps(const SceneSpec& spec,
                               const SceneBodies& scene,
                               const std::filesystem::path& job_file,
                               std::shared_ptr<const RoadTraffic> traffic) {
    return StepsOpening(spec, scene, job_file, std::move(traffic)).run();
}

} // namespace cd
