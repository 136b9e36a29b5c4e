// Messages between clients and the master about geometry and jobs.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/poses/random_poses.hpp"
#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"
#include "common/job/statistics.hpp"
#include "proto/messages/cluster_options.hpp"
#include "proto/messages/session_messages.hpp"
#include "proto/messages/traffic.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Asks which of these meshes the master does not have. Answered by MeshesMissing.
struct MeshesQuery {
    std::vector<Sha256> meshes;
};
/// The meshes of a MeshesQuery that the master does not have.
struct MeshesMissing {
    std::vector<Sha256> meshes;
};

/// Consecutive canonical bytes of a mesh. A client sends the parts in order. The master answers the
/// last one with MeshStored, when it has validated the mesh and built the tree.
struct MeshPart {
    Sha256 mesh;
    std::string name;              ///< File name, for display.
    std::uint64_t bytes_total = 0; ///< Size of the whole mesh.
    std::uint64_t offset = 0;      ///< Position of the first of `bytes` in the mesh.
    Bytes bytes;
};
struct MeshStored {
    Sha256 mesh;
};

/// A body of a job.
struct JobBody {
    Sha256 mesh = {};      ///< Hash of the canonical bytes, in the job's unit.
    std::string name = {}; ///< "a" or "b" unless the job gives a name.
    std::string file = {}; ///< Path of the mesh file, for display.
    std::string unit = {}; ///< Unit of the file's coordinates.
    /// True: the job file gives `unit`. False: `unit` is declared in the mesh file, or the job's.
    bool is_unit_given = false;
    std::string up = {};          ///< "y": the client turned the mesh to z up; "z", empty: no turn.
    bool rounds_to_float = false; ///< True: the client rounded the coordinates to floats.
    bool is_fixed = false;        ///< In a scene: the body has one pose at all steps.
    /// The point of the file's mesh, in the job's unit, that the client made the mesh's origin.
    std::array<double, 3> origin = {};

    friend bool operator==(const JobBody&, const JobBody&) = default;
};

enum class PosesKind : std::uint8_t { Grid = 0, File = 1, Random = 2, Shots = 3, Curve = 4 };

/// The table [shots] of a job, beside its directions and its file.
struct ShotsOrigin {
    double spacing = 0;     ///< Between lines of a grid, in the job's unit; 0: lines of a file.
    std::uint32_t tile = 0; ///< Lines along a side of a bundle.
    std::array<double, 2> offset{}; ///< Of each line in its cell, as shares of the cell's side.
    std::optional<std::uint64_t> jitter_seed = {}; ///< If set, lines lie at random in their cells.
    bool are_rays = false; ///< The file has starts and directions, else both ends.

    friend bool operator==(const ShotsOrigin&, const ShotsOrigin&) = default;
};

/// What a job of a scene of many bodies has besides its bodies and scenarios, for clients that open
/// the job again.
struct SceneOrigin {
    Sha256 head = {};     ///< The hash of `SceneHead`, with which the job's digest starts.
    std::string job = {}; ///< Text of the job file.
    Bytes steps = {};     ///< The steps, packed by the client.

    friend bool operator==(const SceneOrigin&, const SceneOrigin&) = default;
};

/// How a job makes the path between its poses, beside [motion].
struct PathOrigin {
    std::optional<double> max_step = {}; ///< The key of [poses].
    std::optional<double> chord = {}; ///< The key of [motion]; the query's clearance has it, too.
    std::optional<double> clearance = {}; ///< The job's, to which `chord` was added.

    friend bool operator==(const PathOrigin&, const PathOrigin&) = default;
};

/// The origin of a job's poses, used when the job is opened again.
struct PosesOrigin {
    PosesKind kind = PosesKind::File;
    std::optional<RandomPoses> random = {}; ///< For kind Random only.
    /// Path of poses, "-": standard input; for kind Shots of lines; for kind Curve the curve, as in
    /// the job file.
    std::string file = {};
    std::string quat_order = {}; ///< "xyzw" or "wxyz"; empty: the file's own order.
    bool of_both_bodies = false; ///< True: the file has poses of A and B, else of B.
    /// How far a matrix or quaternion of the file may be from a rotation; empty: the default.
    std::optional<double> rigid_tolerance = {};
    LabelColumns labels = {}; ///< Labels sent with the poses.
    /// Unit of the file's translations or of the grid's positions; empty: the job's unit.
    std::string unit = {};
    /// Kind Grid: the axes x, y, z, then roll, pitch, yaw in degrees, as in the job. Empty if
    /// unknown. Kind Shots: the azimuths and the elevations in degrees.
    std::vector<GridAxis> axes = {};
    std::optional<ShotsOrigin> shots = {}; ///< For kind Shots only.
    std::optional<SceneOrigin> scene = {}; ///< Set if and only if the scenarios have steps.
    std::optional<PathOrigin> path = {};   ///< Set if the job has `max_step` or `chord`.

    friend bool operator==(const PosesOrigin&, const PosesOrigin&) = default;
};

/// Patterns of part names of A and B, as the job has them. Pairs of matching parts are ignored.
struct IgnoreLine {
    std::string a;
    std::string b;

    friend bool operator==(const IgnoreLine&, const IgnoreLine&) = default;
};

/// A new job. With a grid the Submit is complete and answered by Accepted; otherwise poses follow
/// in PosesPart, and the master answers PosesEnd with Accepted.
struct Submit {
    std::string name;
    std::string unit;            ///< Unit of poses and results.
    std::string owner;           ///< Set by the master.
    std::int32_t priority = 0;   ///< -10 to 10 (`limits::priority_max`); above 0 for admins.
    std::vector<JobBody> bodies; ///< At least two bodies; their meshes must be stored.
    Query query;
    ClusterOptions cluster;
    PosesOrigin poses;
    std::uint64_t scenarios = 0; ///< Number of scenarios.
    std::optional<Bytes> grid;   ///< `encode_grid`; only for poses of kind Grid.
    /// How long the job is kept after its end, in seconds. 0, or more than the master's own bound:
    /// as long as the master keeps any job.
    std::uint64_t retention_seconds = 0;
    std::vector<IgnoreLine> ignore = {}; ///< The source of `query.ignored`, for display.

    /// Returns with what the job's digest starts; nothing unless the job is a scene.
    [[nodiscard]] std::optional<SceneHead> scene_head() const {
        return poses.scene ? std::optional(SceneHead{poses.scene->head}) : std::nullopt;
    }
};

/// The next run of a submission's poses, in the order of `pack_in_order`.
struct PosesPart {
    Bytes scenarios;        ///< `pack_scenarios`.
    PoseLabels labels = {}; ///< The next labels in submitted order, as many, by announced column.
};
struct PosesEnd {};

struct Accepted {
    JobId job;
};

/// Asks for a job's description. Answered by JobDescription. Errors: NotFound.
struct JobQuery {
    JobId job;
};

/// The `Submit` of a job, including the fields that the master added.
struct JobDescription {
    JobId job;
    std::uint64_t began = 0; ///< Time of acceptance, in seconds since 1970.
    Submit submit;
};

/// Asks for a mesh's canonical bytes from `offset` on. Answered by MeshBytes. Errors: NotFound;
/// BadInput for an offset beyond the end.
struct MeshQuery {
    Sha256 mesh;
    std::uint64_t offset = 0;
};

/// A mesh's canonical bytes from `offset` on, as many as fit into a message.
struct MeshBytes {
    Sha256 mesh;
    std::uint64_t bytes_total = 0;
    std::uint64_t offset = 0;
    Bytes bytes;
};

/// Returns the scenario at a place of an even sample of a job's scenarios. `sample` is the sample's
/// size, at most `limits::page_sample_max`; of a sample of size 0, places are scenarios.
[[nodiscard]] constexpr std::uint64_t
sampled_scenario(std::uint64_t place, std::uint64_t sample, std::uint64_t scenarios) {
    return sample == 0 ? place : place * scenarios / sample;
}

/// Asks for the poses of scenarios [first, first + count), or of these places of a sample. Answered
/// by JobPoses. Errors: NotFound; BadInput for scenarios that the job does not have.
struct PosesQuery {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::uint64_t sample = 0; ///< As of `sampled_scenario`.
};

/// Poses of scenarios, or places, [first, first + count) in submitted order: at least one, at most
/// as many as requested. Contains poses for a job with a grid, too.
struct JobPoses {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    Bytes scenarios; ///< `pack_scenarios`.
    PoseLabels labels = {};
};

enum class JobState : std::uint8_t { Running = 0, Done = 1, Cancelled = 2, Failed = 3 };

[[nodiscard]] std::string_view to_text(JobState state);

/// A long-running scenario and its worker.
struct LongScenario {
    std::uint64_t scenario = 0;
    WorkerId worker;
    std::string name;   ///< Name of the worker.
    double seconds = 0; ///< Time since the scenario's start.
};

/// Whose the job is, and when it has its turn.
struct JobTurn {
    std::string owner;
    std::int32_t priority = 0;
    double share = 0; ///< The job's part of the workers' thread time of the last seconds, 0 to 1.

    friend bool operator==(const JobTurn&, const JobTurn&) = default;
};

struct JobStatus {
    JobId job;
    std::string name;
    JobState state = JobState::Running;
    Summary summary;
    std::optional<Sha256> digest; ///< Hash over all records; set only if Done.
    double seconds = 0; ///< Time from acceptance until now or the end, while the master ran.
    double scenarios_per_second = 0;      ///< Merged scenarios / `seconds`.
    std::string failure;                  ///< Why the job failed; empty if it did not.
    std::vector<Sha256> bodies;           ///< Meshes of the bodies.
    std::uint64_t answered_by_master = 0; ///< Scenarios without colliding distribution roots.
    /// Sum over all received results, including duplicates, whose `effort` does not count.
    JobStatistics statistics;
    double compute_seconds = 0; ///< Computing time of all workers' threads.
    std::string paused;         ///< Why the job is paused; empty if it is not.
    std::vector<LongScenario> long_scenarios;
    std::uint64_t withdrawn = 0;  ///< Results of quarantined workers that were withdrawn.
    std::uint64_t recalled = 0;   ///< Scenarios returned by workers near the job's end.
    std::uint64_t copies = 0;     ///< Speculative copies of scenarios near the job's end.
    std::uint64_t copies_won = 0; ///< Speculative copies answered before their originals.
    JobTraffic traffic;
    /// The distribution depth of each body's tree; empty until the geometry is prepared.
    std::vector<std::uint32_t> depths;
    JobTurn turn;
    std::uint64_t began = 0; ///< Time of acceptance, in seconds since 1970.
};

/// Watches a job. Answered by JobStatus at once and after each change, at most about five times a
/// second, until the state is not Running.
struct Watch {
    JobId job;
};

/// Asks for the state of the cluster. Answered by ClusterStatus.
struct StatusQuery {};

/// A worker's liveness by the time of its last message.
enum class WorkerState : std::uint8_t {
    Alive = 0,
    Silent = 1, ///< Suspected lost: the worker gets no new tasks and keeps those that it has.
    Lost = 2,   ///< The worker's tasks were reassigned.
};

[[nodiscard]] std::string_view to_text(WorkerState state);

struct WorkerStatus {
    WorkerId worker;
    std::string name;
    std::uint32_t threads = 0;
    std::uint64_t cache_bytes = 0;  ///< Limit of the worker's subtree cache.
    std::uint64_t cached_bytes = 0; ///< Size of the worker's subtree cache.
    bool claimed = false;           ///< True: gets no new task until the current one ends.
    bool draining = false;
    std::uint64_t buffered = 0;           ///< Scenarios in the master's buffer for this worker.
    std::uint64_t working = 0;            ///< Scenarios sent to the worker and not yet answered.
    std::uint64_t tasks = 0;              ///< Tasks sent to the worker in this session.
    std::uint64_t scenarios = 0;          ///< Scenarios answered in this session.
    double scenarios_per_second = 0;      ///< Rate while the worker had work.
    std::uint64_t bytes_sent = 0;         ///< To the worker, over the current connection.
    std::uint64_t bytes_received = 0;     ///< From the worker, over the current connection.
    std::uint64_t subtrees_sent = 0;      ///< Blocks that the master sent to the worker.
    std::uint64_t subtree_bytes_sent = 0; ///< Compressed size of the blocks sent.
    CacheTraffic cache;
    bool quarantined = false; ///< A result of the worker was wrong, so it gets no more work.
    WorkerState state = WorkerState::Alive;
    double silent_seconds = 0;              ///< Time since the worker's last message.
    std::optional<RunningScenario> longest; ///< The longest-running scenario in the last heartbeat.
};

struct MeshStatus {
    Sha256 mesh;
    std::string name;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;  ///< Size of the canonical form.
    double build_seconds = 0; ///< Time to build the tree; 0 if it was loaded from disk.
    bool is_needed = false;   ///< True: a kept job or a submission uses the mesh.
};

/// Disk usage of the state directory, bytes.
struct StateSizes {
    std::uint64_t results = 0;
    std::uint64_t poses = 0; ///< Including labels.
    std::uint64_t meshes = 0;
    std::uint64_t trees = 0;   ///< Including blocks.
    std::uint64_t journal = 0; ///< The database of the journal.
    std::uint64_t free = 0;    ///< Free bytes of the file system.

    friend bool operator==(const StateSizes&, const StateSizes&) = default;
};

/// Estimated time left of all running jobs, if so many more workers come.
struct GrowthPoint {
    std::uint32_t workers = 0;
    double seconds = 0;

    friend bool operator==(const GrowthPoint&, const GrowthPoint&) = default;
};

/// How much more workers of the median speed would help.
struct Growth {
    double seconds = 0;            ///< Estimated time left of all running jobs now.
    std::vector<GrowthPoint> more; ///< With 1, 2, 4 ... 1,024 more workers, ascending.
    /// The most additional workers, up to 1,024, that add 80 % of their share of speed. 0: not even
    /// one does.
    GrowthPoint worth;

    friend bool operator==(const Growth&, const Growth&) = default;
};

/// What the master has lost since it started.
struct LossCounts {
    std::uint64_t workers_lost = 0;
    std::uint64_t sessions_resumed = 0;
    std::uint64_t scenarios_given_back = 0; ///< Scenarios of lost workers.

    friend bool operator==(const LossCounts&, const LossCounts&) = default;
};

struct ClusterStatus {
    std::string build;
    double uptime_seconds = 0;
    double cpu_seconds = 0; ///< CPU time of the master, user and system.
    std::vector<WorkerStatus> workers;
    std::vector<JobStatus> jobs;
    std::vector<MeshStatus> meshes;
    std::vector<std::string> alarms; ///< The most recent alarms for the operator.
    std::uint64_t alarm_count = 0;   ///< All alarms, over all incarnations of the master.
    LossCounts losses;
    StateSizes sizes;
    std::optional<Growth> growth = {}; ///< Empty while nothing is known, or no job runs.
};

/// Asks for the records of scenarios [first, first + count), or of these places of a sample.
/// Answered by ResultsPart. Records exist for scenarios already merged.
struct ResultsQuery {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::uint64_t sample = 0; ///< As of `sampled_scenario`.
};

/// Scenarios [first, first + count), by index.
struct ScenarioInterval {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    friend bool operator==(const ScenarioInterval&, const ScenarioInterval&) = default;
};

/// The records, as in `Results`, of all scenarios in [first, next) that have a result. `next` is
/// less than the end of the request if the message would become too large. With a sample, these
/// numbers and those of `held` are places.
struct ResultsPart {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t next = 0;
    std::vector<ScenarioInterval> held; ///< The scenarios of the records, ascending.
    std::uint32_t count = 0;            ///< Number of records.
    Bytes records;
    bool are_packed = true; ///< As in `SentRecords`.
};

/// Asks for a job's contact map. Answered by ContactMapAnswer. Errors: NotFound; Refused for the
/// triangles of a job that is not done.
struct ContactMapQuery {
    JobId job;
    bool only_parts = false; ///< Leave out triangles: only the sums by part, also of a running job.
};

struct ContactMapAnswer {
    JobId job;
    bool is_asked = false; ///< True: the job has a map, or sums by part, by its query.
    std::string withdrawn; ///< Why a requested map does not exist; otherwise empty.
    Bytes map;             ///< `pack_map`; of a job that is not done, over the results so far.
};

/// Cancels a job, or, if `scenario` is set, lets only that scenario fail. Answered by JobStatus.
/// Errors: NotFound; Refused for a scenario that already has a result.
struct Cancel {
    JobId job;
    std::optional<std::uint64_t> scenario = {};
};

/// Removes a job and the meshes that no other job uses. Answered by Removed once the disk no longer
/// has them. Errors: NotFound; Refused for a running job unless `cancel` is set.
struct Remove {
    JobId job;
    bool cancel = false; ///< Cancel the job first if it is running.
};

/// Removes a mesh, its tree and its blocks. Answered by Removed. Errors: NotFound; Refused while a
/// job or a submission uses the mesh.
struct RemoveMesh {
    Sha256 mesh;
};

struct Removed {
    std::uint64_t bytes = 0; ///< Bytes freed on the disk.
};

/// Drains workers: they get no more work and leave when their results are acknowledged. Answered by
/// Draining. Errors: NotFound naming a worker that is not connected; then no worker drains.
struct DrainWorkers {
    std::vector<WorkerId> workers; ///< Empty: all.
    /// The workers exit at once, and their work is reassigned without counting as lost.
    bool now = false;
};

/// The workers that now drain, ascending.
struct Draining {
    std::vector<WorkerId> workers;
};

/// Asks which worker suits a scenario best, and why. Answered by Explained. Errors: NotFound;
/// Refused for a job whose geometry is being prepared; Io when the poses cannot be read.
struct Explain {
    JobId job;
    std::uint64_t scenario = 0;
};

/// A worker's score for a scenario.
struct WorkerScore {
    WorkerId worker;
    std::string name;
    bool may_take = false;            ///< True: the worker is eligible for the scenario now.
    bool is_chosen = false;           ///< True: the strategy would choose this worker now.
    std::uint64_t scenarios = 0;      ///< Scenarios buffered for the worker, or unanswered there.
    double load = 0;                  ///< The job's scenarios buffered for the worker / q.
    std::uint64_t held_triangles = 0; ///< Triangles under the scenario's roots, held or coming.
    std::uint64_t missing_triangles = 0; ///< Triangles under the roots, neither held nor coming.
    // The cost terms, in seconds; 0 if the strategy does not estimate when a scenario is done.
    double backlog = 0;  ///< The worker's other work, divided among its threads.
    double coming = 0;   ///< The remaining transfer of blocks in flight.
    double transfer = 0; ///< The transfer of the missing bytes.
    double blocks = 0;   ///< Requesting and decoding the missing blocks.
    double eviction = 0; ///< Fetching evicted blocks again later.
    double work = 0;     ///< The scenario itself.
};

/// The scores of the workers now, not when the scenario was sent. For an ended job, `why`, the
/// roots and the workers are empty.
struct Explained {
    JobId job;
    std::uint64_t scenario = 0;
    std::string strategy = ClusterOptions{}.strategy;
    bool is_by_time = false;   ///< True: the strategy compares the cost terms of the workers.
    std::string where;         ///< Where the scenario is, in words.
    std::string why;           ///< Why the chosen worker is chosen, in words.
    std::string note;          ///< Limits of these scores, in words; usually empty.
    std::uint32_t roots_a = 0; ///< Number of A's distribution roots that collide with one of B.
    std::uint32_t roots_b = 0;
    std::vector<WorkerScore> workers; ///< Ascending by worker.
    /// Of a motion or a distance, while the job runs. Of a distance it counts the roots whose boxes
    /// are no farther apart than the distance as used; all if there is no distance.
    std::optional<SearchEffort> effort = {};
};

} // namespace cd
