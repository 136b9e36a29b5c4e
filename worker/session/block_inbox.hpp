// The blocks of geometry of a session: requests, arrivals from the master and from other workers,
// and reports to the master on the cache.
#pragma once

#include "worker/cache/subtree_cache.hpp"
#include "worker/execution/worker_job.hpp"
#include "worker/peers/fetcher.hpp"
#include "worker/peers/peer_links.hpp"
#include "worker/peers/peer_server.hpp"
#include "worker/session/carry_over.hpp"
#include "worker/session/session_hub.hpp"
#include "worker/session/traffic_book.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace cd {

/// The parts of a session that exchange blocks with other workers.
struct PeerParts {
    std::shared_ptr<PeerServer> server; ///< Null: serves no blocks.
    PeerKey key;                        ///< Key of other workers' tickets, from the Welcome.
    std::string name;                   ///< This worker's name, for the logs of peers.
    std::shared_ptr<const TlsSlot> tls = std::make_shared<TlsSlot>();
    Network* network = &tcp_network();
};

/// Gets the blocks that scenarios, ranges and hints need, and tells the master what the cache holds
/// and has evicted.
class BlockInbox {
  public:
    using Token = Fetcher::Token;

    /// Takes the cache out of `keep`; `leave` returns the cache.
    BlockInbox(SessionHub& hub,
               MasterLink& master,
               std::shared_ptr<CarryOver> keep,
               PeerParts peers);

    // ---- Messages from the master -------------------------------------------------------------
    /// Adds a tree to the cache. Errors: those of `SubtreeCache::add_tree`.
    [[nodiscard]] Status add_tree(const AddTree& add);
    /// Parks the tree in the cache. Requires that no scenario needs the tree.
    void park_tree(TreeId tree);
    void add_job(const WorkerJob& job) {
        traffic_.job_added(job.id, {job.trees.begin(), job.trees.end()});
    }
    void remove_job(JobId job) { traffic_.job_removed(job); }
    /// Queues the hinted subtrees. Errors: BadFrame for an unknown job, tree or subtree.
    [[nodiscard]] Status hint(const Hint& hint);
    void receive(Subtrees subtrees);
    /// Requests blocks from the sources in order, then the missing ones from the master.
    void fetch(FetchFromPeers directions);

    // ---- Needs of the tasks -------------------------------------------------------------------
    /// Requests the blocks of a scenario; `settle` returns the token when all are cached. The
    /// blocks stay cached until `release`.
    void need(Token token, JobId job, std::vector<SubtreeKey> roots);
    void release(Token token) { fetcher_.finished(token); }
    /// Requests upper trees, which the worker descends for a range of the job.
    void need_tops(JobId job, const std::set<TreeId>& trees);
    [[nodiscard]] bool has_tops(const std::set<TreeId>& trees) const;
    /// Marks cached blocks that a descent needed as just used, and counts them as hits of the job.
    void found(JobId job, const Walked& walked);
    /// Returns the job's traffic since the last call for this job.
    [[nodiscard]] BlockTraffic take_traffic(JobId job) { return traffic_.take(job); }

    // ---- The session --------------------------------------------------------------------------
    /// Lets other workers fetch the cached blocks.
    void serve_peers();
    /// Sends evictions, arrivals and new requests, in this order. Returns the scenarios whose
    /// blocks are all cached now, each once.
    [[nodiscard]] std::vector<Token> settle();
    /// Lists the trees with their cached blocks.
    [[nodiscard]] std::vector<InventoryTree> inventory() const;
    /// Repeats all pending requests in a resumed session, whose inventory has reported all else.
    void ask_again();
    /// Evicts subtrees until the cache takes at most `bytes`. Returns the number of evictions.
    std::size_t let_go(std::uint64_t bytes);
    [[nodiscard]] CacheTraffic traffic() const;
    [[nodiscard]] SubtreeCache& cache() { return cache_; }
    [[nodiscard]] const SubtreeCache& cache() const { return cache_; }
    /// Stops serving other workers, and returns the cache to the CarryOver.
    void leave();

  private:
    /// Decodes a block on a thread. `source` is the sending worker; 0 means the master.
    void open_soon(TreeId tree, SubtreeBlock block, WorkerId source);
    void block_opened(const SubtreeKey& key,
                      const Result<OpenedBlock>& opened,
                      const std::shared_ptr<const SubtreeBlock>& block,
                      WorkerId source);
    // The coroutine keeps the hub alive, because it may run after the session has ended.
    asio::awaitable<void> fetch_from_peers(std::shared_ptr<SessionHub> hub,
                                           FetchFromPeers directions);
    void count(const Fetcher::Step& step);
    void send_evicted();
    /// Reports the arrived blocks soon, together with those that arrive until then.
    void send_held_soon();
    void send_wants(const std::vector<SubtreeKey>& want);

    SessionHub& hub_;
    MasterLink& master_;
    std::shared_ptr<CarryOver> keep_;
    SubtreeCache cache_;
    Fetcher fetcher_;
    PeerParts peers_;
    PeerLinks links_;
    std::map<TreeId, std::vector<RootIndex>> held_; ///< Arrived blocks to report in the next Held.
    asio::steady_timer held_timer_;
    bool sending_held_soon_ = false;
    TrafficBook traffic_;
};

} // namespace cd
