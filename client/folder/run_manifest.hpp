// What a results folder says of its run: run.json.
#pragma once

#include "common/core/hash.hpp"
#include "common/core/result.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/query.hpp"
#include "proto/client_messages.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// With an absolute path where the mesh was read here.
struct ManifestBody : JobBody {
    std::vector<std::string> parts = {};
};

struct ManifestPoses {
    PosesKind kind = PosesKind::File;
    std::uint64_t count = 0;
    /// `hash_of` (poses_hash.hpp); not known while poses are still being made.
    std::optional<Sha256> hash;
    std::optional<Grid> grid;          ///< Of kind Grid.
    std::optional<RandomPoses> random; ///< Of kind Random.
    std::string file;                  ///< Of kind File: as for `PoseFileSpec`.
    std::string quat_order;
    bool of_both_bodies = false;
    std::optional<double> rigid_tolerance;
    std::string unit; ///< Of the file's translations.
    bool has_ids = false;
    bool has_times = false;
};

/// Where a run took place.
struct ManifestPlace {
    std::uint64_t threads = 0; ///< On this machine alone.
    std::string simd;
    std::string master;        ///< Its address; empty: it was this machine.
    std::string job;           ///< The master's id of the job.
    std::uint64_t workers = 0; ///< That the master had when the results were written.
};

struct ManifestFile {
    std::string name; ///< In the folder, with "/" between the parts of a path.
    std::uint64_t bytes = 0;
};

/// run.json as values. Bodies are a list; those of ignored ranges are the first two.
struct RunManifest {
    std::string program; ///< "cdctl 0.1.0"
    std::string commit;  ///< `build_commit` of it.
    std::string command; ///< The command line.
    std::string started; ///< UTC, ISO 8601; of a job on a master, when that accepted it.
    std::string ended;
    ManifestPlace where;
    std::string name;
    std::string unit = "m"; ///< Of the poses and of the results.
    std::string job;        ///< `job_text`, from which the run is run again.
    std::vector<ManifestBody> bodies;
    ManifestPoses poses;
    Query query;
    std::uint64_t answered = 0; ///< Scenarios with a record.
    std::optional<Sha256> digest;
    std::optional<Sha256> map_digest;
    std::vector<std::string> formats;
    std::vector<ManifestFile> files; ///< All in the folder but run.json.

    [[nodiscard]] bool is_complete() const { return digest.has_value(); }
};

/// The document.
[[nodiscard]] std::string manifest_json(const RunManifest& manifest);

/// The inverse. The text may be hostile; keys that are not known are passed over. Errors: BadInput
/// saying what is wrong, also for the format of a later version.
[[nodiscard]] Result<RunManifest> parse_manifest(std::string_view text);

/// Whether two runs have to give the same records: equal meshes, poses and query. Names, files and
/// threads do not matter.
[[nodiscard]] bool is_same_job(const RunManifest& left, const RunManifest& right);

/// A time in UTC: "2026-03-01T12:00:00Z".
[[nodiscard]] std::string iso_time(std::uint64_t unix_seconds);

} // namespace cd
