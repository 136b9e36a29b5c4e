// What clients ask the master, each answered by the message named: geometry and jobs.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/hash.hpp"
#include "common/core/id.hpp"
#include "common/job/merge.hpp"
#include "common/job/query.hpp"
#include "common/job/statistics.hpp"
#include "proto/cluster_options.hpp"
#include "proto/session_messages.hpp"
#include "proto/traffic.hpp"

#include <array>
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
    std::string name; ///< For people: the file's name.
    std::uint64_t bytes_total = 0;
    std::uint64_t offset = 0;
    Bytes bytes;
};
struct MeshStored {
    Sha256 mesh;
};

/// A new job. With a grid it is complete and answered by Accepted; otherwise poses follow in
/// PosesPart, and PosesEnd is answered by Accepted.
struct Submit {
    std::string name;
    std::vector<Sha256> bodies; ///< A and B; they must be stored.
    Query query;
    ClusterOptions cluster;
    std::uint64_t scenarios = 0;
    std::optional<Bytes> grid; ///< `encode_grid`.
};

/// The next scenarios in order.
struct PosesPart {
    Bytes scenarios; ///< `pack_scenarios`.
};
struct PosesEnd {};

struct Accepted {
    JobId job;
};

enum class JobState : std::uint8_t { Running = 0, Done = 1, Cancelled = 2, Failed = 3 };

[[nodiscard]] std::string_view to_text(JobState state);

/// A scenario that takes long, and where.
struct LongScenario {
    std::uint64_t scenario = 0;
    WorkerId worker;
    std::string name;   ///< Of the worker.
    double seconds = 0; ///< Since it was begun.
};

struct JobStatus {
    JobId job;
    std::string name;
    JobState state = JobState::Running;
    Summary summary;
    std::optional<Sha256> digest; ///< When Done.
    double seconds = 0;           ///< Since it was accepted; of a finished job, how long it took.
    double scenarios_per_second = 0;
    std::string failure;
    std::array<Sha256, 2> bodies;
    std::uint64_t answered_by_master = 0; ///< No pair of distribution roots: no worker was asked.
    JobStatistics statistics; ///< Of the scenarios whose results came, also those that came twice.
    double compute_seconds = 0;
    std::string paused; ///< Why it waits; empty: it does not.
    std::vector<LongScenario> long_scenarios;
    std::uint64_t doubted = 0; ///< Results of a quarantined worker that are being computed again.
    // Of scenarios at its end:
    std::uint64_t recalled = 0;   ///< Given back by workers that had not begun them.
    std::uint64_t copies = 0;     ///< Sent to a second worker, beside the first,
    std::uint64_t copies_won = 0; ///< and answered by that one first.
    JobTraffic traffic;
    // Where its trees are cut; nothing until its geometry has been prepared.
    std::optional<std::uint32_t> depth_a;
    std::optional<std::uint32_t> depth_b;
};

/// Answered by JobStatus at once and whenever something changed, at most some five times a second,
/// until the state is not Running.
struct Watch {
    JobId job;
};

/// Answered by ClusterStatus.
struct StatusQuery {};

/// What is known of a worker by what it says, and when.
enum class WorkerState : std::uint8_t {
    Alive = 0,
    Silent = 1, ///< Suspected to be lost: it gets no new work, and keeps what it has.
    Lost = 2,   ///< Its work went to others.
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
    std::uint64_t scenarios = 0;     ///< Answered.
    double scenarios_per_second = 0; ///< Over the time that it had work.
    std::uint64_t bytes_sent = 0;
    std::uint64_t bytes_received = 0;
    std::uint64_t subtrees_sent = 0;
    std::uint64_t subtree_bytes_sent = 0;
    CacheTraffic cache;
    bool quarantined = false; ///< A result of it was wrong: it gets nothing more.
    WorkerState state = WorkerState::Alive;
    double silent_seconds = 0;              ///< Since it was heard of.
    std::optional<RunningScenario> longest; ///< As its last heartbeat said.
};

struct MeshStatus {
    Sha256 mesh;
    std::string name;
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;  ///< Canonical.
    double build_seconds = 0; ///< 0 when its tree was found on disk.
};

struct ClusterStatus {
    std::string build;
    double uptime_seconds = 0;
    double cpu_seconds = 0; ///< Of the master, user and system.
    std::vector<WorkerStatus> workers;
    std::vector<JobStatus> jobs;
    std::vector<MeshStatus> meshes;
    std::vector<std::string> alarms;        ///< What somebody has to look at, the last ones.
    std::uint64_t alarm_count = 0;          ///< All of them, in all lives of the master.
    std::uint64_t workers_lost = 0;         ///< Since the master started: workers that were lost,
    std::uint64_t sessions_resumed = 0;     ///< and that came back in time,
    std::uint64_t scenarios_given_back = 0; ///< and scenarios that stood at lost ones.
};

/// Answered by ResultsPart. Records exist for scenarios already merged.
struct ResultsQuery {
    JobId job;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

/// Records of scenarios [first, first + count) as in `Results`; fewer than asked for where the
/// message would grow too large. Count 0: `first` is not there (yet).
struct ResultsPart {
    JobId job;
    std::uint64_t first = 0;
    std::uint32_t count = 0;
    Bytes records;
};

/// Answered by ContactMapAnswer. Errors: NotFound; Refused for a job that is not done.
struct ContactMapQuery {
    JobId job;
};

struct ContactMapAnswer {
    JobId job;
    bool is_asked = false; ///< The job's query is for maps.
    std::string withdrawn; ///< Why there is none, though one was asked for; else empty.
    Bytes map;             ///< `pack_map`.
};

/// Answered by JobStatus. With a scenario that has no result yet, only that one fails. Errors:
/// NotFound; Refused for a scenario that has one.
struct Cancel {
    JobId job;
    std::optional<std::uint64_t> scenario = {};
};

/// Answered by Explained. Errors: NotFound, also of meshes or poses that are gone; Refused for a
/// job whose geometry is being prepared.
struct Explain {
    JobId job;
    std::uint64_t scenario = 0;
};

/// How a worker scores for a scenario.
struct WorkerScore {
    WorkerId worker;
    std::string name;
    bool may_take = false; ///< It could be given the scenario now.
    bool is_chosen = false;
    std::uint64_t scenarios = 0;      ///< Buffered for it, or at it and unanswered.
    double load = 0;                  ///< Buffered scenarios of the job / q.
    std::uint64_t held_triangles = 0; ///< Of those under the roots that the scenario touches;
    std::uint64_t missing_triangles = 0;
    // Of `earliest-finish`, in seconds; 0 for the others.
    double backlog = 0;  ///< Its other work, over all its threads.
    double coming = 0;   ///< The rest of the blocks under way.
    double transfer = 0; ///< The bytes that it lacks.
    double blocks = 0;   ///< Asking for each block, and opening it.
    double eviction = 0; ///< What must leave its cache, and will have to come again.
    double work = 0;     ///< The scenario itself.
};

/// Scores as they are now, not as they were when the scenario was given out.
struct Explained {
    JobId job;
    std::uint64_t scenario = 0;
    Strategy strategy = Strategy::BestMatch;
    std::string where; ///< The scenario is, in words.
    std::string why;   ///< The chosen worker is chosen, in words.
    std::string note;  ///< What these scores are not, in words; mostly empty.
    std::uint32_t roots_a = 0;
    std::uint32_t roots_b = 0;
    std::vector<WorkerScore> workers; ///< Ascending.
};

} // namespace cd
