// Blocks of geometry in a session: hints, fetches from peers, decoding, and reports to the master.
#include "common/core/host/log.hpp"
#include "worker/session/session.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace cd {

void Session::serve_peers() {
    if (peers_.server == nullptr) {
        return;
    }
    peers_.server->serve(peers_.key, [weak = weak_from_this()](const SubtreeKey& key) {
        const auto session = weak.lock();
        return session == nullptr ? nullptr : session->cache_.block_at(key);
    });
}

Status Session::handle(Hint& hint) {
    const PartialObbTree* const tree = cache_.find(hint.tree);
    if (tree == nullptr || !jobs_.contains(hint.job)) {
        return Error{ErrorCode::BadFrame, "a hint names a job or a tree that is not here"};
    }
    for (const RootIndex root : hint.roots) {
        if (root >= tree->root_count()) {
            return Error{ErrorCode::BadFrame, "a hint names a subtree that does not exist"};
        }
        fetcher_.hint({hint.job, {hint.tree, root}});
    }
    settle_soon();
    return Done{};
}

asio::awaitable<void> Session::fetch_from_peers(std::shared_ptr<Session> self,
                                                FetchFromPeers directions) {
    std::set<RootIndex> left(directions.roots.begin(), directions.roots.end());
    for (const PeerSource& source : directions.sources) {
        // GCC 12 would destroy a temporary in the call below twice.
        const PeerLinks::OnBlock on_block = [&](SubtreeBlock block) {
            left.erase(block.root);
            traffic_.came_from_peer({directions.tree, block.root}, block.compressed.size());
            open_soon(directions.tree, std::move(block), source.worker);
        };
        const PeerOutcome outcome = co_await links_.fetch(source, directions, on_block);
        if (left.empty() || !self->channel_->is_open()) {
            co_return;
        }
        log_info("blocks from a peer failed: tree={} source={} outcome={} left={}",
                 directions.tree.value,
                 source.worker.value,
                 to_text(outcome),
                 left.size());
        const std::vector<RootIndex> roots(left.begin(), left.end());
        channel_->send(FetchFailed{directions.tree, roots, source.worker, outcome});
        if (roots.size() != directions.roots.size()) {
            break; // Tickets of further sources cover exactly the original roots.
        }
    }
    channel_->send(WantSubtrees{directions.tree, {left.begin(), left.end()}});
}

// Hashing and decoding run on a pool thread, so that they do not delay heartbeats.
void Session::open_soon(TreeId tree, SubtreeBlock came, WorkerId source) {
    const SubtreeKey key{tree, came.root};
    const auto block = std::make_shared<const SubtreeBlock>(std::move(came));
    executor_.submit([weak = weak_from_this(), abandoned = abandoned_, key, block, source]() {
        if (abandoned->load()) {
            return Executor::Continuation([] {});
        }
        return Executor::Continuation([weak, key, opened = open_block(*block), block, source] {
            if (const auto session = weak.lock()) {
                session->block_opened(key, opened, block, source);
            }
        });
    });
}

void Session::block_opened(const SubtreeKey& key,
                           const Result<OpenedBlock>& opened,
                           const std::shared_ptr<const SubtreeBlock>& block,
                           WorkerId source) {
    if (abandoned_->load() || end_ != SessionEnd::Lost) {
        return;
    }
    if (!opened && source != WorkerId{}) {
        log_error("damaged block from a peer: tree={} root={} source={} error=\"{}\"",
                  key.tree.value,
                  key.root,
                  source.value,
                  opened.error().detail);
        channel_->send(FetchFailed{key.tree, {key.root}, source, PeerOutcome::Damaged});
        channel_->send(WantSubtrees{key.tree, {key.root}});
        return;
    }
    const auto kept = peers_.server == nullptr ? nullptr : block;
    const Status inserted =
        opened ? cache_.insert(key, opened.value(), kept) : Status(opened.error());
    if (!inserted) {
        return refuse(inserted.error());
    }
    // A block that was evicted at once has arrived too; otherwise it could not be requested again.
    fetcher_.arrived(key);
    if (cache_.has(key)) {
        held_[key.tree].push_back(key.root);
    }
    settle_soon();
}

// ---- Reports to the master ------------------------------------------------------------------

void Session::note_asked(const Fetcher::Step& step) {
    for (const Fetcher::Hinted& hinted : step.hinted) {
        traffic_.hinted(hinted.job, hinted.key);
    }
    for (const Fetcher::Admission& one : step.admitted) {
        const JobId job = tasks_.at(places_.at(one.token).task).job().id;
        traffic_.found(job, one.found);
        for (const SubtreeKey& key : one.asked) {
            traffic_.missed(job, key);
        }
    }
}

void Session::send_evicted() {
    std::map<TreeId, std::vector<RootIndex>> evicted;
    for (const SubtreeKey& key : cache_.take_evicted()) {
        for (const auto& [id, job] : jobs_) {
            if (job->uses(key.tree)) {
                traffic_.evicted(id);
            }
        }
        // The subtree may be cached again.
        if (cache_.at(key) == nullptr) {
            evicted[key.tree].push_back(key.root);
        }
    }
    for (auto& [tree, roots] : evicted) {
        std::sort(roots.begin(), roots.end());
        roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
        channel_->send(Evicted{tree, std::move(roots)});
    }
}

void Session::send_held() {
    for (auto& [tree, roots] : std::exchange(held_, {})) {
        std::sort(roots.begin(), roots.end());
        roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
        // The block may have been evicted again.
        std::erase_if(roots, [&](RootIndex root) { return !cache_.has({tree, root}); });
        if (!roots.empty()) {
            channel_->send(Held{tree, std::move(roots)});
        }
    }
}

void Session::want_tops(const WorkerJob& job) {
    for (const TreeId tree : {job.tree_a, job.tree_b}) {
        if (fetcher_.want_top(tree)) {
            traffic_.missed(job.id, {tree, top_root});
        }
    }
}

bool Session::has_tops(const WorkerJob& job) const {
    return cache_.find(job.tree_a)->has_top() && cache_.find(job.tree_b)->has_top();
}

void Session::send_wants(const std::vector<SubtreeKey>& want) {
    std::map<TreeId, std::vector<RootIndex>> roots;
    for (const SubtreeKey& key : want) {
        roots[key.tree].push_back(key.root);
    }
    for (auto& [tree, wanted] : roots) {
        log_debug("subtrees wanted: tree={} roots={}", tree.value, wanted.size());
        channel_->send(WantSubtrees{tree, std::move(wanted)});
    }
}

} // namespace cd
