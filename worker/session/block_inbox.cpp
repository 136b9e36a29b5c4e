#include "worker/session/block_inbox.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/worker.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace cd {

namespace {

using RootsByTree = std::map<TreeId, std::vector<RootIndex>>;

void sort_distinct(std::vector<RootIndex>& roots) {
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
}

/// Reports arrived blocks to the master.
void report(RootsByTree arrived, const SubtreeCache& cache, MasterLink& master) {
    for (auto& [tree, roots] : arrived) {
        sort_distinct(roots);
        // An arrived block may have been evicted again.
        std::erase_if(roots, [&](RootIndex root) { return !cache.has({tree, root}); });
        if (!roots.empty()) {
            master.send(Held{tree, std::move(roots)});
        }
    }
}

} // namespace

BlockInbox::BlockInbox(SessionHub& hub,
                       MasterLink& master,
                       std::shared_ptr<CarryOver> keep,
                       PeerParts peers)
    : hub_(hub),
      master_(master),
      keep_(std::move(keep)),
      cache_(std::exchange(keep_->cache, SubtreeCache(keep_->cache.bytes_max()))),
      fetcher_(cache_),
      peers_(std::move(peers)),
      links_(peers_.name, peers_.tls, *peers_.network),
      held_timer_(hub.home()) {}

void BlockInbox::leave() {
    held_timer_.cancel();
    if (peers_.server != nullptr) {
        peers_.server->stop_serving();
    }
    cache_.park_all();
    keep_->cache = std::exchange(cache_, SubtreeCache(0));
}

void BlockInbox::serve_peers() {
    if (peers_.server == nullptr) {
        return;
    }
    peers_.server->serve(peers_.key, [this, weak = hub_.weak_from_this()](const SubtreeKey& key) {
        const auto hub = weak.lock();
        return hub == nullptr ? nullptr : cache_.block_at(key);
    });
}

// ---- Messages from the master ---------------------------------------------------------------

Status BlockInbox::add_tree(const AddTree& add) {
    Status added = cache_.add_tree(add);
    if (added) {
        std::vector<RootIndex> held = cache_.held(add.tree);
        log_info("tree added: tree={} roots={} held={}", add.tree.value, add.roots, held.size());
        if (!held.empty()) {
            master_.send(Held{add.tree, std::move(held)});
        }
    }
    return added;
}

void BlockInbox::park_tree(TreeId tree) {
    fetcher_.forget_requests(tree);
    traffic_.tree_removed(tree);
    cache_.park(tree);
    log_info("tree parked: tree={} cached_bytes={}", tree.value, cache_.bytes());
    hub_.settle_soon();
}

Status BlockInbox::hint(const Hint& hint) {
    const PartialObbTree* const tree = cache_.find(hint.tree);
    if (tree == nullptr || !traffic_.has(hint.job)) {
        return Error{ErrorCode::BadFrame, "a hint names a job or a tree that is not here"};
    }
    for (const RootIndex root : hint.roots) {
        if (root >= tree->root_count()) {
            return Error{ErrorCode::BadFrame, "a hint names a subtree that does not exist"};
        }
        fetcher_.hint({hint.job, {hint.tree, root}});
    }
    hub_.settle_soon();
    return Done{};
}

void BlockInbox::receive(Subtrees subtrees) {
    for (SubtreeBlock& block : subtrees.blocks) {
        traffic_.came_from_master({subtrees.tree, block.root}, block.compressed.size());
        open_soon(subtrees.tree, std::move(block), {});
    }
}

void BlockInbox::fetch(FetchFromPeers directions) {
    spawn(hub_.home(),
          "blocks from peers",
          fetch_from_peers(hub_.shared_from_this(), std::move(directions)));
}

asio::awaitable<void> BlockInbox::fetch_from_peers([[maybe_unused]] std::shared_ptr<SessionHub> hub,
                                                   FetchFromPeers directions) {
    std::set<RootIndex> left(directions.roots.begin(), directions.roots.end());
    for (const PeerSource& source : directions.sources) {
        // A variable, because GCC 12 destroys a temporary argument of a co_await expression twice.
        const PeerLinks::OnBlock on_block = [&](SubtreeBlock block) {
            left.erase(block.root);
            traffic_.came_from_peer({directions.tree, block.root}, block.compressed.size());
            open_soon(directions.tree, std::move(block), source.worker);
        };
        const PeerOutcome outcome = co_await links_.fetch(source, directions, on_block);
        if (left.empty() || !master_.is_open()) {
            co_return;
        }
        log_info("blocks from a peer failed: tree={} source={} outcome={} left={}",
                 directions.tree.value,
                 source.worker.value,
                 to_text(outcome),
                 left.size());
        const std::vector<RootIndex> roots(left.begin(), left.end());
        master_.send(FetchFailed{directions.tree, roots, source.worker, outcome});
        if (roots.size() != directions.roots.size()) {
            break; // Tickets of further sources cover exactly the original roots.
        }
    }
    master_.send(WantSubtrees{directions.tree, {left.begin(), left.end()}});
}

// Hashing and decoding run on a pool thread, so that they do not delay heartbeats.
void BlockInbox::open_soon(TreeId tree, SubtreeBlock came, WorkerId source) {
    const SubtreeKey key{tree, came.root};
    const auto block = std::make_shared<const SubtreeBlock>(std::move(came));
    hub_.run_on_thread([this, key, block, source] {
        return [this, key, opened = open_block(*block), block, source] {
            block_opened(key, opened, block, source);
        };
    });
}

void BlockInbox::block_opened(const SubtreeKey& key,
                              const Result<OpenedBlock>& opened,
                              const std::shared_ptr<const SubtreeBlock>& block,
                              WorkerId source) {
    if (!opened && source != WorkerId{}) {
        log_error("damaged block from a peer: tree={} root={} source={} error=\"{}\"",
                  key.tree.value,
                  key.root,
                  source.value,
                  opened.error().detail);
        master_.send(FetchFailed{key.tree, {key.root}, source, PeerOutcome::Damaged});
        master_.send(WantSubtrees{key.tree, {key.root}});
        return;
    }
    const auto kept = peers_.server == nullptr ? nullptr : block;
    const Status inserted =
        opened ? cache_.insert(key, opened.value(), kept) : Status(opened.error());
    if (!inserted) {
        return master_.refuse(inserted.error());
    }
    // A block that was evicted at once counts as arrived, so that it can be requested again.
    fetcher_.arrived(key);
    if (cache_.has(key)) {
        held_[key.tree].push_back(key.root);
    }
    hub_.settle_soon();
}

// ---- Needs of the tasks ---------------------------------------------------------------------

void BlockInbox::need(Token token, JobId job, std::vector<SubtreeKey> roots) {
    fetcher_.add(token, job, std::move(roots));
}

void BlockInbox::need_tops(JobId job, const std::set<TreeId>& trees) {
    for (const TreeId tree : trees) {
        if (fetcher_.want_top(tree)) {
            traffic_.missed(job, {tree, top_root});
        }
    }
}

bool BlockInbox::has_tops(const std::set<TreeId>& trees) const {
    return std::ranges::all_of(trees, [&](TreeId tree) { return cache_.find(tree)->has_top(); });
}

void BlockInbox::found(JobId job, const Walked& walked) {
    for (const SubtreeKey& key : walked.used) {
        cache_.touch(key);
    }
    traffic_.found(job, walked.found);
}

std::size_t BlockInbox::let_go(std::uint64_t bytes) {
    const std::size_t gone = cache_.let_go(bytes);
    hub_.settle_soon();
    return gone;
}

// ---- Reports to the master ------------------------------------------------------------------

std::vector<BlockInbox::Token> BlockInbox::settle() {
    Fetcher::Step step = fetcher_.advance();
    count(step);
    // Evicted comes first; otherwise the master would apply it to the blocks requested next.
    send_evicted();
    send_held_soon();
    send_wants(step.want);
    return std::move(step.ready);
}

void BlockInbox::count(const Fetcher::Step& step) {
    for (const Fetcher::Hinted& hinted : step.hinted) {
        traffic_.hinted(hinted.job, hinted.key);
    }
    for (const Fetcher::Admission& one : step.admitted) {
        traffic_.found(one.job, one.found);
        for (const SubtreeKey& key : one.asked) {
            traffic_.missed(one.job, key);
        }
    }
}

void BlockInbox::send_evicted() {
    RootsByTree evicted;
    for (const SubtreeKey& key : cache_.take_evicted()) {
        traffic_.evicted(key.tree);
        // An evicted subtree may be cached again.
        if (cache_.at(key) == nullptr) {
            evicted[key.tree].push_back(key.root);
        }
    }
    for (auto& [tree, roots] : evicted) {
        sort_distinct(roots);
        master_.send(Evicted{tree, std::move(roots)});
    }
}

void BlockInbox::send_held_soon() {
    const auto wait = hub_.results_wait() / timing::held_waits_per_results_wait;
    if (wait.count() == 0) {
        return report(std::exchange(held_, {}), cache_, master_);
    }
    if (held_.empty() || std::exchange(sending_held_soon_, true)) {
        return;
    }
    held_timer_.expires_after(wait);
    held_timer_.async_wait(
        [this, weak = hub_.weak_from_this()](const boost::system::error_code& error) {
            const auto hub = weak.lock();
            if (hub != nullptr && !error) {
                sending_held_soon_ = false;
                report(std::exchange(held_, {}), cache_, master_);
            }
        });
}

void BlockInbox::send_wants(const std::vector<SubtreeKey>& want) {
    RootsByTree roots;
    for (const SubtreeKey& key : want) {
        roots[key.tree].push_back(key.root);
    }
    for (auto& [tree, wanted] : roots) {
        log_debug("subtrees wanted: tree={} roots={}", tree.value, wanted.size());
        master_.send(WantSubtrees{tree, std::move(wanted)});
    }
}

std::vector<InventoryTree> BlockInbox::inventory() const {
    std::vector<InventoryTree> trees;
    for (const TreeId tree : cache_.trees()) {
        trees.push_back({tree, cache_.held(tree)});
    }
    return trees;
}

void BlockInbox::ask_again() {
    held_.clear();
    (void)cache_.take_evicted();
    send_wants(fetcher_.awaited());
}

CacheTraffic BlockInbox::traffic() const {
    CacheTraffic traffic{traffic_.total(), 0};
    traffic.blocks.evictions = cache_.evictions(); // Includes trees that no job uses.
    traffic.uploaded_bytes = peers_.server == nullptr ? 0 : peers_.server->uploaded_bytes();
    return traffic;
}

} // namespace cd
