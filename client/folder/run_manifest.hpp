// The manifest of a run: run.json in its results folder.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A body of a run and its parts' names. `file` is absolute if this machine imported the mesh.
struct ManifestBody : JobBody {
    std::vector<std::string> parts = {};
};

/// Which columns the labels of the poses have.
struct ManifestLabels {
    bool ids = false;
    bool times = false;
    bool end_times = false; ///< Of motions whose poses have times.
};

struct ManifestPoses {
    PosesKind kind = PosesKind::File;
    std::uint64_t count = 0;
    /// The hash of all poses (`hash_of`); nothing until random poses have all been generated.
    std::optional<Sha256> hash;
    std::optional<Grid> grid;              ///< Set for kind Grid.
    std::optional<RandomPoses> random;     ///< Set for kind Random.
    std::string file;                      ///< Absolute path, or "-"; empty unless kind is File.
    std::string quat_order;                ///< As in `PoseFileSpec`.
    bool of_both_bodies = false;           ///< As in `PoseFileSpec`.
    std::optional<double> rigid_tolerance; ///< As in `PoseFileSpec`.
    std::string unit;                      ///< Unit of translations in the pose file.
    ManifestLabels labels;
};

/// What a scene of many bodies has besides its bodies and poses.
struct ManifestScene {
    Sha256 head;             ///< The hash of its `SceneHead`.
    std::uint64_t steps = 0; ///< Number of steps; the file `steps` in the folder has them.
};

/// Where a run is computed: on this machine or by a master's workers.
struct ManifestPlace {
    std::uint64_t threads = 0; ///< Number of threads, for a run on this machine.
    std::string simd;
    std::string master;        ///< Address HOST:PORT; empty for a run on this machine.
    std::string job;           ///< The master's id of the job.
    std::uint64_t workers = 0; ///< Number of the master's workers when results were written.
};

struct ManifestFile {
    std::string name; ///< Path within the folder, with "/" as separator.
    std::uint64_t bytes = 0;
};

/// The program that wrote the folder, and when it ran.
struct ManifestOrigin {
    std::string program; ///< "cdctl 0.1.0"
    std::string commit;  ///< `build_commit` of the program.
    std::string command; ///< The command line.
    std::string started; ///< UTC, ISO 8601; for a master's job when it was accepted.
    std::string ended;
};

/// The earlier run from which a run takes results instead of running their scenarios.
struct ManifestReuse {
    std::string run;              ///< Absolute path of its results folder, or its id as a job.
    std::optional<Sha256> digest; ///< Result digest; nothing if it lacks scenarios.
    std::uint64_t scenarios = 0;  ///< Number of results taken; 0 until the run is complete.
};

/// What results the folder has.
struct ManifestOutcome {
    std::uint64_t answered = 0;          ///< Number of scenarios with a record.
    std::optional<Sha256> digest;        ///< Result digest; nothing while scenarios are missing.
    std::optional<Sha256> map_digest;    ///< Digest of the contact map; nothing without one.
    std::optional<ManifestReuse> reused; ///< Nothing if all scenarios were run.
    /// Above 0: the run of an earlier version, which left boxes of this size undecided.
    double tolerance = 0;
};

/// The content of run.json.
struct RunManifest {
    ManifestOrigin origin;
    ManifestPlace where;
    std::string name;
    std::string unit = "m"; ///< Unit of poses and results.
    std::string job;        ///< Text of `job_text`, to run the job again.
    std::vector<ManifestBody> bodies;
    ManifestPoses poses;
    std::optional<ManifestScene> scene; ///< Nothing for a job of two bodies.
    Query query;
    ManifestOutcome outcome;
    std::vector<std::string> formats;
    std::vector<ManifestFile> files; ///< All files of the folder except run.json.

    /// Returns with what the digest starts; nothing unless the run is of a scene.
    [[nodiscard]] std::optional<SceneHead> scene_head() const {
        return scene ? std::optional(SceneHead{scene->head}) : std::nullopt;
    }
    [[nodiscard]] bool is_complete() const { return outcome.digest.has_value(); }
};

/// Returns the manifest as a JSON document.
[[nodiscard]] std::string manifest_json(const RunManifest& manifest);

/// Parses what `manifest_json` wrote. The text is untrusted; unknown keys are ignored. Errors:
/// BadInput with the reason, also for the format of a later version.
[[nodiscard]] Result<RunManifest> parse_manifest(std::string_view text);

/// True if two runs must give equal records, since their meshes, poses and query are equal. Names,
/// files and threads do not matter.
[[nodiscard]] bool is_same_job(const RunManifest& left, const RunManifest& right);

/// Refuses a run with a tolerance, since no run gives its answers again. Errors: BadInput.
[[nodiscard]] Status check_exact(const RunManifest& manifest);

/// True if both runs take results from one earlier run, or both from none.
[[nodiscard]] bool reuses_same_run(const RunManifest& left, const RunManifest& right);

/// Returns a time in UTC: "2026-03-01T12:00:00Z".
[[nodiscard]] std::string iso_time(std::uint64_t unix_seconds);

} // namespace cd
