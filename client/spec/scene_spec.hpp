// A scene of many bodies, as the job file describes it.
#pragma once

#include "client/spec/body_spec.hpp"
#include "client/spec/fcd_spec.hpp"
#include "client/spec/poses_spec.hpp"
#include "client/spec/rules_spec.hpp"
#include "common/geometry/pose.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// An entry of [bodies]: a body, or several with one mesh file.
struct SceneBodySpec {
    std::string name;  ///< The key in [bodies].
    BodySpec mesh;     ///< Without a name.
    std::string group; ///< Empty: none.
    /// Number of the instances NAME.0, NAME.1, ...; nothing: one body, NAME.
    std::optional<std::uint32_t> count = std::nullopt;
    bool is_split = false;                            ///< Each part is a body NAME.PART.
    std::optional<Pose> pose = std::nullopt;          ///< The pose at all steps.
    std::optional<PoseFileSpec> poses = std::nullopt; ///< A file with a pose for each step.
    std::uint32_t line = 0;                           ///< Line in the job file.
};

/// The table [poses] of a scene: a file with a pose of each of its bodies for each step.
struct ScenePosesSpec {
    PoseFileSpec file;
    /// The names of the bodies in the order of an array's second axis; empty for a CSV file.
    std::vector<std::string> body_order;
    bool nan_is_absent = false; ///< A body whose numbers are all NaN is absent.
    std::uint32_t line = 0;     ///< Line in the job file.
};

struct SceneSpec {
    std::vector<SceneBodySpec> bodies; ///< In the order of the job file.
    std::optional<ScenePosesSpec> poses = std::nullopt;
    std::optional<FcdSpec> fcd = std::nullopt; ///< In the place of `poses`.
    RulesSpec rules;
    std::optional<ShotsSpec> shots =
        std::nullopt; ///< Lines, which alone the bodies are tested with.
};

/// Says why no body may have this name: "a body's name has 1 to 256 bytes"; nothing if one may.
[[nodiscard]] std::optional<std::string> problem_of_body_name(std::string_view name);

/// True if the vehicles of `SceneSpec::fcd` are the bodies of an entry of [bodies].
[[nodiscard]] bool is_of_vehicles(const SceneSpec& scene, const SceneBodySpec& body);

/// Reads the tables [bodies], [poses] and [rules] of a job. `unit` is the job's, `file` the job
/// file. Throws a `Refusal`, also for tables and keys that only a job of two bodies has.
[[nodiscard]] SceneSpec
read_scene(const TomlFields& job, const std::string& unit, const std::filesystem::path& file);

} // namespace cd
