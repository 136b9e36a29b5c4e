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

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Answered by MeshesMissing.
struct MeshesQuery {
    std::vector<Sha256> meshes;
};
struct MeshesMissing {
    std::vector<Sha256> meshes;
};

/// A run of a mesh's canonical bytes. Parts come in order; the last is answered by MeshStored, when
/// the mesh has been validated and its tree built.
struct MeshPart {
    Sha256 mesh;
    std::string name; ///< File name, for display.
    std::uint64_t bytes_total = 0;
    std::uint64_t offset = 0;
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
    /// The job gives `unit`; otherwise it is declared in the file, or is the job's own.
    bool is_unit_given = false;
    std::string up = {};          ///< "y": turned to z up; "z" or empty: not turned.
    bool rounds_to_float = false; ///< Coordinates were rounded to floats.

    friend bool operator==(const JobBody&, const JobBody&) = default;
};

enum class PosesKind : std::uint8_t { Grid = 0, File = 1, Random = 2 };

/// The origin of a job's poses, used when the job is opened again.
struct PosesOrigin {
    PosesKind kind = PosesKind::File;
    std::optional<RandomPoses> random = {}; ///< Kind Random.
    std::string file = {};                  ///< Kind File; "-" is standard input.
    std::string quat_order = {};            ///< "xyzw", "wxyz", or empty.
    bool of_both_bodies = false;
    std::optional<double> rigid_tolerance = {};
    LabelColumns labels = {}; ///< Labels sent with the poses.
    /// Unit of the file's translations or of the grid's positions; empty: the job's unit.
    std::string unit = {};
    /// Kind Grid: the axes x, y, z, then roll, pitch, yaw in degrees, as in the job. Empty if
    /// unknown.
    std::vector<GridAxis> axes = {};

    friend bool operator==(const PosesOrigin&, const PosesOrigin&) = default;
};

/// Patterns of part names of A and of B in the words of the job; their pairs are ignored.
struct IgnoreLine {
    std::string a;
    std::string b;

    friend bool operator==(const IgnoreLine&, const IgnoreLine&) = default;
};

/// A new job. With a grid it is complete and answered by Accepted; otherwise poses follow in
/// PosesPart, and PosesEnd is answered by Accepted.
struct Submit {
    std::string name;
    std::string unit;            ///< Unit of poses, tolerance and results.
    std::string owner;           ///< Set by the master.
    std::int32_t priority = 0;   ///< Must be 0 in this version.
    std::vector<JobBody> bodies; ///< Two; their meshes must be stored.
    Query query;
    ClusterOptions cluster;
    PosesOrigin poses;
    std::uint64_t scenarios = 0;
    std::optional<Bytes> grid; ///< `encode_grid`; only for poses of kind Grid.
    /// How long the job is kept after its end, in seconds. 0, or more than the master's own bound:
    /// as long as the master keeps any job.
    std::uint64_t retention_seconds = 0;
    std::vector<IgnoreLine> ignore = {}; ///< The source of `query.ignored`, for display.
};

/// The next scenarios in order.
struct PosesPart {
    Bytes scenarios;        ///< `pack_scenarios`.
    PoseLabels labels = {}; ///< Labels of these scenarios, in the announced columns.
};
struct PosesEnd {};

struct Accepted {
    JobId job;
};

/// Answered by JobDescription. Errors: NotFound.
struct JobQuery {
    JobId job;
};

/// The `Submit` of a job and the fields that the master added.
struct JobDescription {
    JobId job;
    std::uint64_t began = 0; ///< Time of acceptance, in seconds since 1970.
    Submit submit;
};

/// Answered by MeshBytes. Errors: NotFound; BadInput for an offset beyond the end.
struct MeshQuery {
    Sha256 mesh;
    std::uint64_t offset = 0;
};

/// Part of a mesh's canonical bytes, as many as fit into a message.
struct MeshBytes {
    Sha256 mesh;
    std::uint64_t bytes_total = 0;
    std::uint64_t offset = 0;
    Bytes bytes;
};

/// Answered by JobPoses. Errors: NotFound; BadInput for scenarios that the job does not have.
struct PosesQuery {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Poses of scenarios [first, first + count) in submitted order: at least one, at most as many as
/// requested. Also answers for a job with a grid.
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
    double seconds = 0; ///< Time since its start.
};

struct JobStatus {
    JobId job;
    std::string name;
    JobState state = JobState::Running;
    Summary summary;
    std::optional<Sha256> digest; ///< Set if Done.
    double seconds = 0;           ///< Time from acceptance until now or the end.
    double scenarios_per_second = 0;
    std::string failure;
    std::vector<Sha256> bodies;           ///< Meshes of the bodies.
    std::uint64_t answered_by_master = 0; ///< Scenarios without colliding roots.
    JobStatistics statistics;             ///< Sum over all received results, including duplicates.
    double compute_seconds = 0;
    std::string paused; ///< Why the job is paused; empty if it is not.
    std::vector<LongScenario> long_scenarios;
    std::uint64_t withdrawn = 0;  ///< Results of quarantined workers that were withdrawn.
    std::uint64_t recalled = 0;   ///< Scenarios returned by workers near the job's end.
    std::uint64_t copies = 0;     ///< Speculative copies of scenarios near the job's end.
    std::uint64_t copies_won = 0; ///< Speculative copies answered before their originals.
    JobTraffic traffic;
    /// The distribution depth of each body's tree; empty until the geometry is prepared.
    std::vector<std::uint32_t> depths;
    std::string owner;
    std::uint64_t began = 0; ///< Time of acceptance, in seconds since 1970.
};

/// Answered by JobStatus at once and after each change, at most about five times a second, until
/// the state is not Running.
struct Watch {
    JobId job;
};

/// Answered by ClusterStatus.
struct StatusQuery {};

/// A worker's liveness by the time of its last message.
enum class WorkerState : std::uint8_t {
    Alive = 0,
    Silent = 1, ///< Suspected lost: it gets no new tasks and keeps its own.
    Lost = 2,   ///< Its tasks were reassigned.
};

[[nodiscard]] std::string_view to_text(WorkerState state);

struct WorkerStatus {
    WorkerId worker;
    std::string name;
    std::uint32_t threads = 0;
    std::uint64_t cache_bytes = 0;
    std::uint64_t cached_bytes = 0;
    bool claimed = false;
    bool draining = false;
    std::uint64_t buffered = 0; ///< Scenarios in the proxy's buffer.
    std::uint64_t working = 0;  ///< Scenarios at the worker.
    std::uint64_t tasks = 0;
    std::uint64_t scenarios = 0;     ///< Answered scenarios.
    double scenarios_per_second = 0; ///< Rate while it had work.
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
    std::uint64_t subtrees_sent = 0;
    std::uint64_t subtree_bytes_sent = 0;
    CacheTraffic cache;
    bool quarantined = false; ///< One of its results was wrong; it gets no more work.
    WorkerState state = WorkerState::Alive;
    double silent_seconds = 0;              ///< Time since its last message.
    std::optional<RunningScenario> longest; ///< From its last heartbeat.
};

struct MeshStatus {
    Sha256 mesh;
    std::string name;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;  ///< Size of the canonical form.
    double build_seconds = 0; ///< 0 if the tree was loaded from disk.
    bool is_needed = false;   ///< A kept job or a submission uses it.
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

struct ClusterStatus {
    std::string build;
    double uptime_seconds = 0;
    double cpu_seconds = 0; ///< CPU time of the master, user and system.
    std::vector<WorkerStatus> workers;
    std::vector<JobStatus> jobs;
    std::vector<MeshStatus> meshes;
    std::vector<std::string> alarms;        ///< The most recent alarms for the operator.
    std::uint64_t alarm_count = 0;          ///< All alarms, over all incarnations of the master.
    std::uint64_t workers_lost = 0;         ///< Workers lost since the master started.
    std::uint64_t sessions_resumed = 0;     ///< Sessions resumed since the master started.
    std::uint64_t scenarios_given_back = 0; ///< Scenarios of lost workers since the master started.
    StateSizes sizes;
};

/// Answered by ResultsPart. Records exist for scenarios already merged.
struct ResultsQuery {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Consecutive scenarios.
struct ScenarioInterval {
    std::uint64_t first = 0;
    std::uint64_t count = 0;

    friend bool operator==(const ScenarioInterval&, const ScenarioInterval&) = default;
};

/// The records, as in `Results`, of all scenarios in [first, next) that have a result. `next` is
/// less than the end of the request if the message would become too large.
struct ResultsPart {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t next = 0;
    std::vector<ScenarioInterval> held; ///< The scenarios of the records, ascending.
    std::uint32_t count = 0;            ///< Number of records.
    Bytes records;
};

/// Answered by ContactMapAnswer. Errors: NotFound; Refused for a job that is not done.
struct ContactMapQuery {
    JobId job;
};

struct ContactMapAnswer {
    JobId job;
    bool is_asked = false; ///< The job's query asks for maps.
    std::string withdrawn; ///< Why a requested map does not exist; otherwise empty.
    Bytes map;             ///< `pack_map`.
};

/// Answered by JobStatus. With a scenario that has no result yet, only that one fails. Errors:
/// NotFound; Refused for a scenario that has one.
struct Cancel {
    JobId job;
    std::optional<std::uint64_t> scenario = {};
};

/// Removes a job and the meshes that no other job uses. Answered by Removed once this is on disk.
/// Errors: NotFound; Refused for a running job unless `cancel` is set.
struct Remove {
    JobId job;
    bool cancel = false; ///< Cancel the job first if it is running.
};

/// Removes a mesh, its tree and its blocks. Answered by Removed. Errors: NotFound; Refused while a
/// job uses it.
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

/// Answered by Explained. Errors: NotFound; Refused for a job whose geometry is being prepared; Io
/// when the poses cannot be read.
struct Explain {
    JobId job;
    std::uint64_t scenario = 0;
};

/// A worker's score for a scenario.
struct WorkerScore {
    WorkerId worker;
    std::string name;
    bool may_take = false; ///< The worker is eligible for the scenario now.
    bool is_chosen = false;
    std::uint64_t scenarios = 0;      ///< Scenarios buffered for the worker, or unanswered there.
    double load = 0;                  ///< Buffered scenarios of the job / q.
    std::uint64_t held_triangles = 0; ///< Triangles of the scenario's roots in its cache.
    std::uint64_t missing_triangles = 0; ///< Triangles of the scenario's roots that it lacks.
    // The cost terms of `earliest-finish`, in seconds; 0 for other strategies.
    double backlog = 0;  ///< The worker's other work, divided among its threads.
    double coming = 0;   ///< The remaining transfer of blocks in flight.
    double transfer = 0; ///< The transfer of the missing bytes.
    double blocks = 0;   ///< Requesting and decoding each missing block.
    double eviction = 0; ///< Fetching evicted blocks again later.
    double work = 0;     ///< The scenario itself.
};

/// Current scores, not those at the time of distribution. For an ended job, `why`, the roots and
/// the workers are empty.
struct Explained {
    JobId job;
    std::uint64_t scenario = 0;
    Strategy strategy = Strategy::BestMatch;
    std::string where; ///< Where the scenario is, in words.
    std::string why;   ///< Why the chosen worker is chosen, in words.
    std::string note;  ///< Limits of these scores, in words; usually empty.
    std::uint32_t roots_a = 0;
    std::uint32_t roots_b = 0;
    std::vector<WorkerScore> workers; ///< Ascending.
};

} // namespace cd
