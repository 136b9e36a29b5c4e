// What master and workers say of work and geometry, and workers to each other.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/job/query.hpp"
#include "common/job/result/result.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/query_statistics.hpp"
#include "common/tree/subtree.hpp"
#include "proto/messages/traffic.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A tree cut at a depth, as the master numbers them while it runs.
using TreeId = Id<struct TreeTag>;

// ---- Master to worker -----------------------------------------------------------------------

/// From now on the worker may be asked about this tree. Nothing of it is there, but for what the
/// worker kept of the same cut from a session before. Its top is a block like those of its roots,
/// under the number `top_root`, and is asked for by who needs it.
struct AddTree {
    TreeId tree;
    SubtreeForm form = SubtreeForm::Wide; ///< Of its blocks.
    Sha256 cut;                           ///< Names all of its blocks; the same in every session.
    Sha256 top;                           ///< Names the block of the top (`encode_top`).
    std::uint32_t roots = 0;
    std::uint32_t triangles = 0; ///< Of the whole tree.
};

/// Frees the tree, its blocks and what waits for them. Comes when no job uses the tree.
struct RemoveTree {
    TreeId tree;
};

/// A block, compressed: of one distribution root, or of the top. The hash names the uncompressed
/// bytes.
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
    std::vector<TreeId> trees; ///< The tree of each body.
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

} // namespace cd
