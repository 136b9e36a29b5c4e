// What travels between the programs: one struct a message. PROTOCOL.md tells the order of play.
#pragma once

#include "common/core/bytes.hpp"
#include "common/core/hash.hpp"
#include "common/core/id.hpp"
#include "common/core/result.hpp"
#include "common/job/merge.hpp"
#include "common/job/query.hpp"
#include "common/job/result.hpp"
#include "common/job/statistics.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/subtree.hpp"
#include "proto/certificate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace cd {

inline constexpr std::uint16_t protocol_version_min = 6;
inline constexpr std::uint16_t protocol_version_max = 6;

/// A tree cut at a depth, as the master numbers them while it runs.
using TreeId = Id<struct TreeTag>;

enum class Role : std::uint8_t {
    Worker = 1,
    Client = 2,
    Peer = 3,
    Joiner = 4, ///< Wants a certificate, and nothing else.
};

// ---- Both kinds of peer ---------------------------------------------------------------------

/// First message of whoever connects.
struct Hello {
    std::uint16_t version_min = protocol_version_min;
    std::uint16_t version_max = protocol_version_max;
    Role role = Role::Client;
    std::string name;              ///< For people: host and process, or what --name said.
    std::string build;             ///< Version of the program.
    std::uint32_t threads = 0;     ///< Of a worker.
    std::uint64_t cache_bytes = 0; ///< Of a worker: the limit of its subtree cache.
    std::uint16_t peer_port = 0;   ///< Of a worker: where others fetch blocks from it; 0: nowhere.
    double weight = 1;             ///< Of a worker: multiplies its speed, where that counts.
    std::uint64_t instance = 0;    ///< Of a worker: drawn when its process started, kept since.
    // Of a worker that would go on with a session whose connection broke: what its Welcome said.
    std::uint64_t session = 0; ///< The WorkerId; 0: it has none to go on with.
    std::uint64_t epoch = 0;
};

/// A secret of the master and one worker, by which the worker knows the master's tickets.
using PeerKey = Sha256;

/// The master's answer to a Hello that it accepts.
struct Welcome {
    std::uint16_t version = protocol_version_max; ///< The greatest that both speak.
    std::uint64_t id = 0;                         ///< A WorkerId, or the client's number.
    std::string build;
    PeerKey peer_key; ///< Of a worker; else zeros.
    Sha256 cluster; ///< Names the master's state: numbers of jobs mean the same as long as it does.
    std::uint64_t epoch = 0; ///< Names the master's process.
    bool is_resumed = false; ///< The worker's session goes on: what both hold of it still counts.
    std::uint32_t heartbeat_ms = 0;  ///< The period of heartbeats, which a worker keeps to, too;
    std::uint32_t lost_after_ms = 0; ///< after so long a silence its work goes to others.
};

/// The other side cannot or will not. To a client it answers the request before it.
struct Failure {
    ErrorCode code = ErrorCode::Refused;
    std::string detail;
};

/// What became of the subtrees that scenarios needed at a worker.
struct BlockTraffic {
    std::uint64_t hits = 0;   ///< Needed by a scenario and there already.
    std::uint64_t misses = 0; ///< Asked for, because a scenario needed them.
    std::uint64_t hinted = 0; ///< Asked for, because the master had named them.
    std::uint64_t evictions = 0;
    std::uint64_t master_bytes = 0; ///< Compressed, from the master,
    std::uint64_t peer_bytes = 0;   ///< and from other workers.

    BlockTraffic& operator+=(const BlockTraffic& other);
    friend bool operator==(const BlockTraffic&, const BlockTraffic&) = default;
};

/// Of one worker, since it was welcomed.
struct CacheTraffic {
    BlockTraffic blocks;
    std::uint64_t uploaded_bytes = 0; ///< To other workers.

    friend bool operator==(const CacheTraffic&, const CacheTraffic&) = default;
};

/// Of one job, at all workers, as far as its results have come.
struct JobTraffic {
    BlockTraffic blocks;            ///< A block counts for the job that asked for it; one that is
                                    ///< evicted, for each job that uses its tree.
    std::uint64_t result_bytes = 0; ///< From workers, packed; also what came twice.

    friend bool operator==(const JobTraffic&, const JobTraffic&) = default;
};

/// A scenario that a thread is busy with.
struct RunningScenario {
    JobId job;
    std::uint64_t scenario = 0;
    double seconds = 0; ///< Since it was begun.

    friend bool operator==(const RunningScenario&, const RunningScenario&) = default;
};

struct Heartbeat {
    std::uint64_t sequence = 0;
    std::uint64_t cached_bytes = 0;              ///< Of a worker.
    std::uint64_t waiting = 0;                   ///< Scenarios at the worker not yet answered.
    CacheTraffic traffic;                        ///< Of a worker.
    std::optional<RunningScenario> longest = {}; ///< Of those that run at the worker.
};

// ---- Master to worker -----------------------------------------------------------------------

/// From now on the worker may be asked about this tree. Its slots are empty, but for what the
/// worker kept of the same cut from a session before.
struct AddTree {
    TreeId tree;
    SubtreeForm form = SubtreeForm::Wide; ///< Of its blocks.
    Sha256 cut;                           ///< Names all of its blocks; the same in every session.
    std::vector<ObbNode> top;             ///< The nodes of a `TreeTop`.
};

/// Frees the tree, its blocks and what waits for them. Comes when no job uses the tree.
struct RemoveTree {
    TreeId tree;
};

/// One distribution root's block, compressed. The hash names the uncompressed bytes.
struct SubtreeBlock {
    RootIndex root = 0;
    Sha256 hash;
    Bytes compressed;
};

struct Subtrees {
    TreeId tree;
    std::vector<SubtreeBlock> blocks;
};

/// From now on tasks of this job may come. Its trees have been added.
struct AddJob {
    JobId job;
    TreeId tree_a;
    TreeId tree_b;
    Query query;
    std::optional<Bytes> grid; ///< `encode_grid`, of a job whose poses it tells.
};

/// Frees the job, and drops what waits or runs for it. Its trees may stay.
struct RemoveJob {
    JobId job;
};

/// The scenario is not to be answered: what runs for it stops, what waits for it goes.
struct DropScenario {
    JobId job;
    std::uint64_t scenario = 0;
    TaskId task = {}; ///< Of this one alone: another worker has answered it. 0: of all of the job.
};

/// A task: scenarios that one worker gets together (paper, 6.4.3), analysed by the master.
struct Batch {
    TaskId task;
    JobId job;
    Bytes scenarios;                         ///< `pack_scenarios`.
    std::vector<std::uint32_t> pair_offsets; ///< scenarios + 1 entries, from 0.
    std::vector<RootPair> pairs;             ///< The colliding distribution roots.
};

/// A task whose worker finds the colliding roots itself.
struct ScenarioRange {
    TaskId task;
    JobId job;
    std::uint64_t first = 0; ///< Of a job with a grid: these places on it.
    std::uint64_t count = 0;
    Bytes scenarios; ///< Of a job without: `pack_scenarios`, so many; `first` is 0.
};

/// Others have nothing to do: give back of this task what has not begun. Answered by Recalled.
struct Recall {
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Of a Batch: these, ascending.
    std::uint64_t places = 0;             ///< Of a ScenarioRange: all but the first so many.
};

/// Scenarios of the job that are likely to come to the worker will need these subtrees. Whoever has
/// room for them and nothing better to do asks for them; nothing follows from it otherwise.
struct Hint {
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.
};

/// To a worker: nothing more comes, finish what is there, then close. From a worker that its own
/// host ends: give me nothing more; what I have not begun comes back with EndOfTask.
struct Drain {};

/// End now.
struct Terminate {
    std::string reason;
};

/// One worker as a source of blocks for another one.
struct PeerSource {
    WorkerId worker;
    std::string host;
    std::uint16_t port = 0;
    std::uint64_t ticket = 0; ///< Good for one PeerFetch of these roots,
    Sha256 proof;             ///< by this `ticket_proof` (peer_ticket.hpp).
};

/// An answer to WantSubtrees: the blocks of these roots come from another worker, the first of the
/// sources that gives them. What none gives is wanted again. Roots ascend; `hashes` are theirs.
struct FetchFromPeers {
    TreeId tree;
    std::vector<RootIndex> roots;
    std::vector<Sha256> hashes;
    std::vector<PeerSource> sources;
};

// ---- Worker to master -----------------------------------------------------------------------

struct WantSubtrees {
    TreeId tree;
    std::vector<RootIndex> roots;
};

/// Results of some of a task's scenarios, in bulk: canonical records, packed together
/// (packed_records.hpp).
struct Results {
    TaskId task; ///< 0: of a task of an earlier session.
    JobId job;
    std::uint32_t count = 0;
    Bytes records;
    QueryStatistics statistics;
    double compute_seconds = 0; ///< Summed over the worker's threads.
    std::uint64_t sequence = 0; ///< The worker's number for the message, until it is acknowledged.
    BlockTraffic traffic;       ///< Of the job, since the worker's message of its results before.
    Bytes map;                  ///< `pack_map` of all these scenarios, where the query is for maps.
};

/// These messages of results are on the master's disk, or nobody wants them: the worker drops them.
/// Others it sends again in its next session.
struct ResultsKept {
    std::vector<std::uint64_t> sequences;
};

/// First in a session: of these cuts the worker still has blocks. The master adds those trees that
/// it uses, and the worker says Held.
struct Holding {
    std::vector<Sha256> cuts;
};

/// All that was given back of a task, since it came: the worker neither begins nor answers it.
struct Recalled {
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Of a Batch, ascending.
    std::uint64_t places = 0;             ///< Of a ScenarioRange: it keeps the first so many.
};

/// A tree that the worker has, and which of its slots are filled; roots ascend.
struct StandingTree {
    TreeId tree;
    std::vector<RootIndex> held;
};

/// What the worker has of a session that goes on, after the results that it sends again: what is
/// not named got lost on its way, or has ended.
struct Standing {
    std::vector<StandingTree> trees;
    std::vector<JobId> jobs;
    std::vector<Recalled> tasks; ///< Each with what was given back of it.
};

/// All results of the task have been sent.
struct EndOfTask {
    TaskId task;
};

/// These slots are empty again.
struct Evicted {
    TreeId tree;
    std::vector<RootIndex> roots;
};

/// These slots are filled. Only from then on they count as held.
struct Held {
    TreeId tree;
    std::vector<RootIndex> roots;
};

enum class PeerOutcome : std::uint8_t {
    Given = 0,
    Busy = 1,        ///< It serves as many others as it may.
    Missing = 2,     ///< It does not hold them (any more).
    Unreachable = 3, ///< No connection, or no answer in time.
    Damaged = 4,     ///< What it gave has not its hash.
    Refused = 5,     ///< It does not take the ticket.
};

[[nodiscard]] std::string_view to_text(PeerOutcome outcome);

/// The source did not give these roots.
struct FetchFailed {
    TreeId tree;
    std::vector<RootIndex> roots;
    WorkerId source;
    PeerOutcome outcome = PeerOutcome::Unreachable;
};

// ---- Worker to worker -----------------------------------------------------------------------

/// Answered by Subtrees with what is there, if the ticket is good, and then by PeerFetched.
struct PeerFetch {
    TreeId tree;
    std::vector<RootIndex> roots;
    std::uint64_t ticket = 0;
    Sha256 proof;
};

/// The end of the answer. `missing`: the roots that were asked for and did not come.
struct PeerFetched {
    TreeId tree;
    std::vector<RootIndex> missing;
    PeerOutcome outcome = PeerOutcome::Given;
};

// ---- Client to master, each answered by the message named -----------------------------------

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

/// Whether the master analyses a scenario before it goes to a worker (paper, 6.4.6), or the worker
/// finds the colliding roots of a whole range of scenarios itself.
enum class AnalysisMode : std::uint8_t {
    Auto = 0, ///< Whichever costs less, as measured.
    Always = 1,
    Never = 2, ///< But for scenarios that were lost with a worker.
};

[[nodiscard]] std::string_view to_text(AnalysisMode mode);
[[nodiscard]] std::optional<AnalysisMode> analysis_mode_from_text(std::string_view text);
[[nodiscard]] std::span<const std::string_view> analysis_mode_names();

enum class Strategy : std::uint8_t {
    BestMatch = 0,
    BestMatchLoad = 1,
    Random = 2,
    Lowest = 3,
    BestMatchPull = 4,  ///< The paper's first form (5.1): a free worker takes what is most similar.
    EarliestFinish = 5, ///< Ours, in seconds. Batches follow time; q and claim are not looked at.
};

[[nodiscard]] std::string_view to_text(Strategy strategy);
[[nodiscard]] std::optional<Strategy> strategy_from_text(std::string_view text);
/// In the order of their numbers.
[[nodiscard]] std::span<const std::string_view> strategy_names();

/// The [cluster] table of a job. Under a tolerance the depths are `tolerance_depth` of the trees,
/// and those given here are not looked at.
struct ClusterOptions {
    Strategy strategy = Strategy::BestMatch;
    /// Distribution depths (paper: 12 or 10 for the fixed body, 6 for the moved one). Where none is
    /// given, the body's tree tells it.
    std::optional<std::uint32_t> depth_a = {};
    std::optional<std::uint32_t> depth_b = {};
    std::uint32_t q = 20;      ///< A buffer is full at q scenarios
    std::uint32_t v_kb = 4096; ///< or V kB.
    bool claim = false;        ///< The paper's strict claiming: one task at a worker at a time.
    std::uint64_t seed = 1;    ///< Of the random strategy.
    /// With strict claiming it is Always.
    AnalysisMode analysis = AnalysisMode::Auto;
    bool hints = true; ///< Workers hear what they are likely to need next.
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
    // Of scenarios at its end, since this master started:
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
    std::uint64_t alarm_count = 0;          ///< All of them, since the master started,
    std::uint64_t workers_lost = 0;         ///< and workers that were lost,
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

// ---- Who wants to belong to the cluster; over TLS alone ---------------------------------------

/// Of a Joiner without a certificate. Answered by Certified.
struct Join {
    std::uint64_t token = 0; ///< Its number.
    Sha256 proof;            ///< `join_proof` (join_token.hpp).
    std::string name;        ///< For people: what the certificate will call its holder.
    std::string request;     ///< PEM, of `make_certificate_request`.
};

/// Of a Joiner with a certificate: another one like it. Answered by Certified.
struct Renew {
    std::string request; ///< PEM.
};

struct Certified {
    std::string certificate; ///< PEM, like
    std::string authority;   ///< the certificate that it is signed with.
};

/// Of an admin, as a client. Answered by TokenCreated.
struct TokenCreate {
    CertifiedRole role = CertifiedRole::Worker;
    std::uint64_t seconds = 0; ///< From now on.
    std::uint32_t uses = 1;
};

struct TokenCreated {
    std::string token; ///< As `to_text` writes it.
};

/// In the order of their numbers on the wire, which start at 1 and never change.
using Message = std::variant<Hello,
                             Welcome,
                             Failure,
                             Heartbeat,
                             AddTree,
                             RemoveTree,
                             Subtrees,
                             Batch,
                             Drain,
                             Terminate,
                             WantSubtrees,
                             Results,
                             EndOfTask,
                             Evicted,
                             MeshesQuery,
                             MeshesMissing,
                             MeshPart,
                             MeshStored,
                             Submit,
                             PosesPart,
                             PosesEnd,
                             Accepted,
                             Watch,
                             JobStatus,
                             StatusQuery,
                             ClusterStatus,
                             ResultsQuery,
                             ResultsPart,
                             Cancel,
                             FetchFromPeers,
                             Held,
                             FetchFailed,
                             PeerFetch,
                             PeerFetched,
                             Explain,
                             Explained,
                             AddJob,
                             RemoveJob,
                             ScenarioRange,
                             ResultsKept,
                             Holding,
                             Join,
                             Renew,
                             Certified,
                             TokenCreate,
                             TokenCreated,
                             Standing,
                             DropScenario,
                             Recall,
                             Recalled,
                             Hint,
                             ContactMapQuery,
                             ContactMapAnswer>;

} // namespace cd
