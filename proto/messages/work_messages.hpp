// Messages about work and geometry between master and workers, and between workers.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/id.hpp"
#include "common/geometry/part_runs.hpp"
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

/// A tree cut at a depth, numbered by one incarnation of the master.
using TreeId = Id<struct TreeTag>;

// ---- Master to worker -----------------------------------------------------------------------

/// Announces a tree that later messages may name. The worker has none of its blocks, except those
/// kept from an earlier session with this cut. The upper tree is a block with the number `top_root`
/// and is sent on request.
struct AddTree {
    TreeId tree;
    SubtreeForm form = SubtreeForm::Wide; ///< Form of the tree's blocks.
    Sha256 cut;                           ///< Identifies the tree's blocks in every session.
    Sha256 top;                           ///< Hash of the upper tree's block (`encode_top`).
    std::uint32_t roots = 0;              ///< Number of distribution roots.
    std::uint32_t triangles = 0;          ///< Triangles of the whole tree.
};

/// Frees the tree and its blocks, and drops scenarios that wait for them. Sent when no job uses the
/// tree.
struct RemoveTree {
    TreeId tree;
};

/// A compressed block of one distribution root or the upper tree. `hash` covers the uncompressed
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

/// Announces a job, before its tasks and after its trees.
struct AddJob {
    JobId job;
    std::vector<TreeId> trees; ///< The tree of each body.
    Query query;
    std::optional<Bytes> grid; ///< `encode_grid`; empty for a job with a list of poses.
    /// The runs of each body's parts, for a job that sums contacts by part; else empty.
    std::vector<std::vector<PartRun>> parts = {};
    /// The radius of each body (`body_radius`) for a job of motions; else empty.
    std::vector<double> radii = {};
};

/// Frees the job and drops its waiting and running scenarios. Its trees may stay.
struct RemoveJob {
    JobId job;
};

/// Stops a running scenario or drops a waiting one, because the master no longer needs its result.
struct DropScenario {
    JobId job;
    std::uint64_t scenario = 0;
    TaskId task = {}; ///< The only task to drop the scenario from; 0: all tasks.
};

/// A task: scenarios to search. If the master has analysed them, the task lists their colliding
/// distribution roots (paper, 6.4.3); otherwise the worker finds these itself.
struct WorkUnit {
    TaskId task;
    JobId job;
    std::uint64_t first = 0; ///< First position on the job's grid; 0 with `scenarios`.
    std::uint64_t count = 0; ///< Number of scenarios.
    Bytes scenarios;         ///< `pack_scenarios`; empty: grid positions [first, first + count).
    /// Scenario i has `pairs` [offset i, offset i + 1): count + 1 entries. Empty: not analysed.
    std::vector<std::uint32_t> pair_offsets;
    /// Colliding pairs of distribution roots; for motions a list of roots (`query_roots`).
    std::vector<RootPair> pairs;
    std::uint32_t results_wait_ms = 0; ///< Results may wait this long for others of the unit.

    [[nodiscard]] bool is_analysed() const { return !pair_offsets.empty(); }
};

/// Asks a worker to return scenarios that have not begun, since idle workers can run them. Answered
/// by Recalled.
struct Recall {
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Analysed unit: scenarios to return, ascending.
    std::uint64_t kept = 0;               ///< Other units: number of first scenarios to keep.
};

/// Names subtrees that the worker's future scenarios of the job are likely to need. An idle worker
/// with free cache requests them; others may ignore the message.
struct Hint {
    JobId job;
    TreeId tree;
    std::vector<RootIndex> roots; ///< Ascending.
};

/// To a worker: no more work comes; the worker finishes the running scenarios, then closes. From a
/// worker: the master shall send no more work; EndOfTask returns the scenarios that have not begun.
struct Drain {};

/// The worker must close at once.
struct Terminate {
    std::string reason;
};

/// A worker that can serve blocks to another one.
struct PeerSource {
    WorkerId worker;
    std::string host;
    std::uint16_t port = 0;
    std::uint64_t ticket = 0; ///< Valid for one PeerFetch of the roots.
    Sha256 proof;             ///< `ticket_proof` of the ticket (peer_ticket.hpp).
};

/// An answer to WantSubtrees: the worker fetches these blocks from the sources, in order. It then
/// requests from the master the blocks that no source gives. `roots` ascend; `hashes` are parallel
/// to `roots`.
struct FetchFromPeers {
    TreeId tree;
    std::vector<RootIndex> roots;
    std::vector<Sha256> hashes;
    std::vector<PeerSource> sources;
};

// ---- Worker to master -----------------------------------------------------------------------

/// Requests blocks of distribution roots, or of the upper tree (`top_root`).
struct WantSubtrees {
    TreeId tree;
    std::vector<RootIndex> roots;
};

/// Results of some of a task's scenarios: canonical records (packed_records.hpp).
struct Results {
    TaskId task; ///< 0: a task of an earlier session.
    JobId job;
    std::uint32_t count = 0;
    Bytes records;
    bool are_packed = true; ///< As in `SentRecords`.
    QueryStatistics statistics;
    double compute_seconds = 0; ///< Computing time, summed over the worker's threads.
    std::uint64_t sequence = 0; ///< Number by which ResultsKept acknowledges the message.
    BlockTraffic traffic;       ///< Traffic of the job since the worker's last Results for the job.
    Bytes map; ///< `pack_map` of these scenarios; empty unless contacts are summed.
};

/// Acknowledges Results that are on the master's disk or no longer needed; the worker drops them.
/// The worker sends all other Results again on its next connection.
struct ResultsKept {
    std::vector<std::uint64_t> sequences;
};

/// Sent at the start of a session: lists the cuts of which the worker has kept blocks. The master
/// sends AddTree for each cut that a job uses, and the worker answers with Held.
struct Holding {
    std::vector<Sha256> cuts;
};

/// Lists all scenarios of a task that the worker has returned so far, and neither begins nor
/// answers any more.
struct Recalled {
    TaskId task;
    std::vector<std::uint64_t> scenarios; ///< Returned scenarios, ascending.
    /// Not analysed unit: all scenarios after so many first ones are returned as well.
    std::uint64_t kept = 0;
};

/// A tree that the worker has.
struct InventoryTree {
    TreeId tree;
    std::vector<RootIndex> held; ///< Roots whose blocks are in the worker's cache, ascending.
};

/// The worker's inventory when a session resumes, sent after its unacknowledged results. Anything
/// not listed was lost in transit or has ended.
struct Inventory {
    std::vector<InventoryTree> trees;
    std::vector<JobId> jobs;
    std::vector<Recalled> tasks; ///< Each task with its returned scenarios.
};

/// All results of the task have been sent.
struct EndOfTask {
    TaskId task;
};

/// Reports roots whose blocks the worker has evicted.
struct Evicted {
    TreeId tree;
    std::vector<RootIndex> roots;
};

/// Reports roots whose blocks are in the worker's cache now. Until then, the master does not count
/// the worker as a holder of these blocks.
struct Held {
    TreeId tree;
    std::vector<RootIndex> roots;
};

enum class PeerOutcome : std::uint8_t {
    Given = 0,
    Busy = 1,        ///< The source is at its limit of uploads.
    Missing = 2,     ///< The source does not have all blocks.
    Unreachable = 3, ///< No connection, or no answer in time.
    Damaged = 4,     ///< A block does not match its hash.
    Refused = 5,     ///< The source rejects the ticket.
};

[[nodiscard]] std::string_view to_text(PeerOutcome outcome);

/// Reports roots whose blocks a source did not give.
struct FetchFailed {
    TreeId tree;
    std::vector<RootIndex> roots;
    WorkerId source;
    PeerOutcome outcome = PeerOutcome::Unreachable;
};

// ---- Worker to worker -----------------------------------------------------------------------

/// Asks another worker for blocks. Answered by Subtrees with the cached blocks, if the ticket is
/// valid, then by PeerFetched.
struct PeerFetch {
    TreeId tree;
    std::vector<RootIndex> roots;
    std::uint64_t ticket = 0;
    Sha256 proof;
};

/// Ends the answer to a PeerFetch. `missing`: requested roots that were not sent.
struct PeerFetched {
    TreeId tree;
    std::vector<RootIndex> missing;
    PeerOutcome outcome = PeerOutcome::Given;
};

} // namespace cd
