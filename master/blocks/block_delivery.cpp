#include "master/blocks/block_delivery.hpp"

#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/wire.hpp"
#include "master/base/mutation.hpp"
#include "master/base/run_on.hpp"
#include "proto/access/peer_ticket.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace cd {

bool BlockDelivery::knows(WorkerId worker, TreeId tree) const {
    return links_.contains(worker) && parts_.trees.find(tree) != nullptr;
}

Status BlockDelivery::check_roots(TreeId tree, const std::vector<RootIndex>& roots) const {
    return parts_.trees.find(tree)->has_blocks(roots)
               ? Status(Done{})
               : Error{ErrorCode::BadFrame, "it names a root that does not exist"};
}

void BlockDelivery::worker_joined(WorkerId worker,
                                  std::shared_ptr<Channel> channel,
                                  const PeerKey& key,
                                  std::uint16_t port) {
    Link link;
    link.host = channel->peer_host();
    link.channel = std::move(channel);
    link.key = key;
    link.port = port;
    links_.emplace(worker, std::move(link));
    director_.worker_joined(worker, port != 0);
    probe(worker);
}

void BlockDelivery::worker_left(WorkerId worker) {
    links_.erase(worker);
    act(director_.worker_left(worker, parts_.loop.now()));
}

void BlockDelivery::worker_detached(WorkerId worker) {
    if (const auto link = links_.find(worker); link != links_.end()) {
        link->second.queue.clear();
        act(director_.worker_left(worker, parts_.loop.now()));
    }
}

void BlockDelivery::worker_returned(WorkerId worker, std::shared_ptr<Channel> channel) {
    if (const auto link = links_.find(worker); link != links_.end()) {
        worker_detached(worker);
        link->second.host = channel->peer_host();
        link->second.channel = std::move(channel);
        director_.worker_joined(worker, link->second.port != 0);
        probe(worker);
    }
}

void BlockDelivery::probe(WorkerId worker) {
    const Link& link = links_.at(worker);
    if (link.port != 0) {
        spawn(parts_.executor,
              "probe of a worker's port",
              probe(worker, {link.host, link.port}, link.channel));
    }
}

asio::awaitable<void>
BlockDelivery::probe(WorkerId worker, Endpoint endpoint, std::weak_ptr<Channel> channel) {
    const Status reached = co_await parts_.network.reach(endpoint, timing::peer_connect_timeout);
    const auto link = links_.find(worker);
    if (reached || closed_ || link == links_.end() || link->second.channel != channel.lock()) {
        co_return;
    }
    log_warning("worker cannot serve other workers: worker={} port={} reason=\"{}\"",
                worker.value,
                endpoint.port,
                reached.error().detail);
    act(director_.not_reached(worker, parts_.loop.now()));
}

Status BlockDelivery::wanted(WorkerId worker, const WantSubtrees& want) {
    if (!knows(worker, want.tree)) {
        return Done{};
    }
    Status there = check_roots(want.tree, want.roots);
    if (there) {
        act(director_.wanted(worker, want.tree, want.roots, parts_.loop.now()));
    }
    return there;
}

Status BlockDelivery::held(WorkerId worker, const Held& held) {
    if (!knows(worker, held.tree)) {
        return Done{};
    }
    Status there = check_roots(held.tree, held.roots);
    if (there) {
        act(director_.held(worker, held.tree, held.roots, parts_.loop.now()));
    }
    return there;
}

void BlockDelivery::evicted(WorkerId worker, const Evicted& evicted) {
    if (knows(worker, evicted.tree)) {
        act(director_.evicted(worker, evicted.tree, evicted.roots, parts_.loop.now()));
    }
}

void BlockDelivery::failed(WorkerId worker, const FetchFailed& failed) {
    if (!knows(worker, failed.tree)) {
        return;
    }
    log_info("fetch from a peer failed: worker={} source={} tree={} roots={} outcome={}",
             worker.value,
             failed.source.value,
             failed.tree.value,
             failed.roots.size(),
             to_text(failed.outcome));
    const bool was_avoided = director_.is_avoided(failed.source);
    act(director_.peer_failed(
        worker, failed.source, failed.tree, failed.roots, failed.outcome, parts_.loop.now()));
    if (!was_avoided && director_.is_avoided(failed.source)) {
        log_warning("worker no longer serves other workers: worker={} outcome={}",
                    failed.source.value,
                    to_text(failed.outcome));
    }
}

void BlockDelivery::tree_removed(TreeId tree) {
    for (auto& [worker, link] : links_) {
        const auto is_of_tree = [&](const BlockKey& block) { return block.tree == tree; };
        std::erase_if(link.queue, is_of_tree);
    }
    act(director_.tree_removed(tree, parts_.loop.now()));
}

std::optional<BlockDelivery::PeerPort> BlockDelivery::peer_port_of(WorkerId worker) const {
    const auto link = links_.find(worker);
    if (link == links_.end() || link->second.port == 0) {
        return std::nullopt;
    }
    return PeerPort{link->second.port, !director_.is_avoided(worker)};
}

BlockDelivery::Sent BlockDelivery::sent_to(WorkerId worker) const {
    const auto link = links_.find(worker);
    return link == links_.end() ? Sent{} : link->second.sent;
}

// ---- Decisions of the director ----------------------------------------------------------------

void BlockDelivery::act(const BlockActions& actions) {
    for (const BlockAction& action : actions) {
        if (const auto* block = std::get_if<SendBlock>(&action)) {
            send(*block);
        } else {
            direct(std::get<SendToPeers>(action));
        }
    }
    if (!watching_) {
        watch_time();
    }
}

void BlockDelivery::send(const SendBlock& action) {
    Link& link = links_.at(action.to);
    link.queue.push_back(action.block);
    if (!std::exchange(link.sending, true)) {
        spawn(parts_.executor, "subtrees to a worker", send_queue(action.to));
    }
}

void BlockDelivery::direct(const SendToPeers& action) {
    const auto geometry = parts_.trees.find(action.tree);
    FetchFromPeers directions;
    directions.tree = action.tree;
    directions.roots = action.roots;
    for (const RootIndex root : action.roots) {
        directions.hashes.push_back(geometry->hash(root));
    }
    for (const WorkerId source : action.sources) {
        Link& from = links_.at(source);
        const std::uint64_t ticket = ++from.ticket_last;
        const Sha256 proof = ticket_proof(from.key, ticket, action.tree, action.roots);
        directions.sources.push_back({source, from.host, from.port, ticket, proof});
    }
    links_.at(action.to).channel->send(directions);
}

asio::awaitable<void> BlockDelivery::send_queue(WorkerId worker) {
    for (;;) {
        const auto link = links_.find(worker);
        if (link == links_.end() || link->second.queue.empty()) {
            if (link != links_.end()) {
                link->second.sending = false;
            }
            co_return;
        }
        const BlockKey first = link->second.queue.front();
        const auto channel = link->second.channel;
        if (!send_some(link->second, first.tree, *parts_.trees.find(first.tree))) {
            co_await send_anew(worker, first);
        }
        if (!mutated(Mutation::TooMuchInFlight)) {
            co_await channel->wait_until_queued_below(limits::subtrees_queue_bytes_max);
        }
    }
}

bool BlockDelivery::send_some(Link& link, TreeId tree, const Cut& cut) {
    Subtrees subtrees;
    subtrees.tree = tree;
    std::uint64_t bytes = 0;
    while (!link.queue.empty() && link.queue.front().tree == tree &&
           bytes < limits::subtrees_bytes_min) {
        Result<SubtreeBlock> block = cut.read(link.queue.front().root);
        if (!block) {
            break;
        }
        bytes += cut.compressed_bytes(block.value().root);
        subtrees.blocks.push_back(std::move(block.value()));
        link.queue.pop_front();
    }
    const bool is_any = !subtrees.blocks.empty();
    if (is_any) {
        send_blocks(link, cut, subtrees);
    }
    return is_any;
}

void BlockDelivery::send_blocks(Link& link, const Cut& cut, const Subtrees& subtrees) {
    for (const SubtreeBlock& block : subtrees.blocks) {
        ++link.sent.blocks;
        link.sent.bytes += cut.compressed_bytes(block.root);
    }
    link.channel->send(subtrees);
}

asio::awaitable<void> BlockDelivery::send_anew(WorkerId worker, BlockKey block) {
    const auto geometry = parts_.trees.find(block.tree);
    auto make = [geometry, block] { return geometry->block(block.root); };
    SubtreeBlock made = co_await run_on(parts_.pool, make);
    const auto link = links_.find(worker);
    if (link != links_.end() && !link->second.queue.empty() &&
        link->second.queue.front() == block) {
        link->second.queue.pop_front();
        send_blocks(link->second, *geometry, {block.tree, {std::move(made)}});
    }
}

void BlockDelivery::watch_time() {
    watching_ = !closed_ && director_.open() != 0;
    if (watching_) {
        parts_.loop.after(timing::peer_check_period, [this] {
            act(director_.time_is(parts_.loop.now()));
            watch_time();
        });
    }
}

void BlockDelivery::close() {
    closed_ = true;
    for (auto& [worker, link] : links_) {
        link.queue.clear();
    }
}

} // namespace cd
