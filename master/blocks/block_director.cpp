#include "master/blocks/block_director.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <utility>

namespace cd {

// ---- Events -----------------------------------------------------------------------------------

void BlockDirector::worker_joined(WorkerId worker, bool serves) {
    const bool is_new = peers_.try_emplace(worker).second;
    CD_CHECK(is_new);
    peers_.at(worker).serves = serves;
    servers_ += serves ? 1 : 0;
    note_places(worker);
}

BlockActions BlockDirector::worker_left(WorkerId worker, Time now) {
    const auto found = peers_.find(worker);
    if (found == peers_.end()) {
        return {};
    }
    Event event{now, {}, {}, {}};
    for (const BlockKey& block : std::set<BlockKey>(found->second.holds)) {
        lose_hold(worker, block, event);
    }
    const auto comes = found->second.comes;
    for (const auto& [block, fetch] : comes) {
        forget_delivery(worker, block, event);
    }
    const auto waits_for = found->second.waits_for;
    for (const auto& [block, since] : waits_for) {
        forget_delivery(worker, block, event);
    }
    // Workers that fetch from the lost one notice and report it.
    for (auto& [id, fetch] : fetches_) {
        if (fetch.source == worker) {
            fetch.source = {};
        }
    }
    servers_ -= found->second.serves ? 1 : 0;
    peers_.erase(found);
    free_.erase(worker);
    return settle(std::move(event));
}

BlockActions
BlockDirector::wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now) {
    Event event{now, {}, {}, {}};
    std::map<WorkerId, std::vector<RootIndex>> given;
    for (const RootIndex root : roots) {
        want(worker, {tree, root}, given, event);
    }
    for (auto& [source, from_it] : given) {
        fetch(worker, tree, std::move(from_it), source, event);
    }
    return settle(std::move(event));
}

BlockActions
BlockDirector::held(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now) {
    Event event{now, {worker}, {}, {}};
    for (const RootIndex root : roots) {
        const BlockKey block{tree, root};
        forget_delivery(worker, block, event);
        add_hold(worker, block);
    }
    return settle(std::move(event));
}

BlockActions
BlockDirector::evicted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now) {
    if (mutated(Mutation::EvictionIgnored)) {
        return {};
    }
    Event event{now, {}, {}, {}};
    for (const RootIndex root : roots) {
        forget_delivery(worker, {tree, root}, event);
        lose_hold(worker, {tree, root}, event);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::peer_failed(WorkerId worker,
                                        WorkerId source,
                                        TreeId tree,
                                        std::span<const RootIndex> roots,
                                        PeerOutcome how,
                                        Time now) {
    if (!peers_.contains(worker)) {
        return {};
    }
    Event event{now, {}, {}, {}};
    bool was_named = false;
    for (const RootIndex root : roots) {
        const BlockKey block{tree, root};
        const auto comes = peers_.at(worker).comes.find(block);
        if (comes == peers_.at(worker).comes.end() || comes->second == 0) {
            continue;
        }
        Fetch& fetch = fetches_.at(comes->second);
        if (std::ranges::find(fetch.named, source) == fetch.named.end()) {
            continue;
        }
        was_named = true;
        if (fetch.source == source) {
            free_place(fetch, event);
        }
        if (how == PeerOutcome::Missing) {
            lose_hold(source, block, event);
        }
    }
    const auto found = peers_.find(source);
    if (was_named && found != peers_.end() &&
        (how == PeerOutcome::Unreachable || how == PeerOutcome::Damaged)) {
        Peer& peer = found->second;
        peer.cannot_reach_it.insert(worker);
        peer.is_avoided |= how == PeerOutcome::Damaged ||
                           peer.cannot_reach_it.size() >= limits::peer_unreachable_by_max;
        serves_fewer(source, event);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::not_reached(WorkerId source, Time now) {
    Event event{now, {}, {}, {}};
    if (const auto found = peers_.find(source); found != peers_.end()) {
        found->second.is_avoided = true;
        serves_fewer(source, event);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::tree_removed(TreeId tree, Time now) {
    Event event{now, {}, {}, {}};
    const auto begin = blocks_.lower_bound({tree, 0});
    auto end = begin;
    for (; end != blocks_.end() && end->first.tree == tree; ++end) {
        const BlockKey& block = end->first;
        for (auto& [worker, peer] : peers_) {
            peer.holds.erase(block);
            peer.could_give.erase(block);
            stop_waiting(worker, block);
            const auto comes = peer.comes.find(block);
            if (comes != peer.comes.end()) {
                if (const auto fetch = fetches_.find(comes->second);
                    fetch != fetches_.end() && --fetch->second.left == 0) {
                    free_place(fetch->second, event);
                    fetches_.erase(fetch);
                }
                peer.comes.erase(comes);
            }
        }
    }
    blocks_.erase(begin, end);
    return settle(std::move(event));
}

BlockActions BlockDirector::time_is(Time now) {
    Event event{now, {}, {}, {}};
    const auto line = line_;
    for (const auto& [place, worker] : line) {
        const auto waits_for = peers_.at(worker).waits_for;
        for (const auto& [block, since] : waits_for) {
            if (now - since >= limits::peer_wait_max) {
                send_from_master(worker, block, event);
            }
        }
    }
    std::vector<std::pair<WorkerId, BlockKey>> late;
    for (const auto& [worker, peer] : peers_) {
        for (const auto& [block, id] : peer.comes) {
            if (id != 0 && now >= fetches_.at(id).deadline) {
                late.emplace_back(worker, block);
            }
        }
    }
    for (const auto& [worker, block] : late) {
        forget_delivery(worker, block, event);
        send_from_master(worker, block, event);
    }
    return settle(std::move(event));
}

// ---- Questions --------------------------------------------------------------------------------

std::size_t BlockDirector::open() const {
    std::size_t open = 0;
    for (const auto& [worker, peer] : peers_) {
        open += peer.comes.size() + peer.waits_for.size();
    }
    return open;
}

bool BlockDirector::is_avoided(WorkerId worker) const {
    const auto peer = peers_.find(worker);
    return peer != peers_.end() && peer->second.is_avoided;
}

bool BlockDirector::can_serve(WorkerId source, WorkerId worker) const {
    const auto peer = peers_.find(source);
    return source != worker && peer != peers_.end() && peer->second.serves &&
           !peer->second.is_avoided && !peer->second.cannot_reach_it.contains(worker);
}

bool BlockDirector::is_worth_waiting(const Block& block, WorkerId worker) const {
    const auto serves = [&](WorkerId other) { return can_serve(other, worker); };
    return servers_ != 0 && (std::ranges::any_of(block.holders, serves) ||
                             std::ranges::any_of(block.on_the_way_to, serves));
}

WorkerId
BlockDirector::first_source(const Block& block,
                            WorkerId worker,
                            const std::map<WorkerId, std::vector<RootIndex>>& given) const {
    const auto may_give = [&](WorkerId source) {
        return block.holders.contains(source) && can_serve(source, worker);
    };
    // Picks the source with the fewest uploads among those not yet used in this event.
    WorkerId best;
    std::size_t least = limits::peer_uploads_max;
    std::size_t looked_at = 0;
    for (const WorkerId source : free_.size() < block.holders.size() ? free_ : block.holders) {
        if (!free_.contains(source) || given.contains(source) || !may_give(source)) {
            continue;
        }
        if (const std::size_t uploads = peers_.at(source).uploads; uploads < least) {
            best = source;
            least = uploads;
        }
        if (least == 0 || ++looked_at == limits::sources_looked_at_max) {
            break;
        }
    }
    if (best != WorkerId{}) {
        return best;
    }
    std::pair<std::size_t, std::size_t> best_load;
    for (const auto& [source, roots] : given) {
        const std::pair load{roots.size(), peers_.at(source).uploads};
        if (may_give(source) && (best == WorkerId{} || load < best_load)) {
            best = source;
            best_load = load;
        }
    }
    return best;
}

// ---- What an event does to one block ----------------------------------------------------------

void BlockDirector::want(WorkerId worker,
                         const BlockKey& block,
                         std::map<WorkerId, std::vector<RootIndex>>& given,
                         Event& event) {
    Peer& peer = peers_.at(worker);
    if (peer.waits_for.contains(block)) {
        return;
    }
    if (const auto comes = peer.comes.find(block); comes != peer.comes.end()) {
        if (comes->second != 0) { // The peers failed to deliver the block.
            forget_delivery(worker, block, event);
            send_from_master(worker, block, event);
        }
        return;
    }
    lose_hold(worker, block, event); // The worker itself reports that it lacks the block.
    Block& wanted = blocks_[block];
    if (const WorkerId source = first_source(wanted, worker, given); source != WorkerId{}) {
        given[source].push_back(block.root);
    } else if (is_worth_waiting(wanted, worker)) {
        wait_for(worker, block, event);
    } else {
        send_from_master(worker, block, event);
    }
}

void BlockDirector::wait_for(WorkerId worker, const BlockKey& block, Event& event) {
    Peer& peer = peers_.at(worker);
    if (peer.waits_for.empty()) {
        peer.place = ++place_last_;
        line_.emplace(peer.place, worker);
    }
    peer.waits_for.emplace(block, event.now);
    Block& awaited = blocks_.at(block);
    if (awaited.awaited_by.empty()) {
        for (const WorkerId holder : awaited.holders) {
            peers_.at(holder).could_give.insert(block);
        }
    }
    awaited.awaited_by.emplace(peer.place, worker);
}

void BlockDirector::stop_waiting(WorkerId worker, const BlockKey& block) {
    Peer& peer = peers_.at(worker);
    if (peer.waits_for.erase(block) == 0) {
        return;
    }
    Block& awaited = blocks_.at(block);
    awaited.awaited_by.erase(peer.place);
    if (awaited.awaited_by.empty()) {
        for (const WorkerId holder : awaited.holders) {
            peers_.at(holder).could_give.erase(block);
        }
    }
    if (peer.waits_for.empty()) {
        line_.erase(peer.place);
    }
}

void BlockDirector::send_from_master(WorkerId worker, const BlockKey& block, Event& event) {
    forget_delivery(worker, block, event);
    peers_.at(worker).comes.emplace(block, FetchId{0});
    blocks_[block].on_the_way_to.insert(worker);
    if (mutated(Mutation::HeldWhenSent)) {
        add_hold(worker, block);
    }
    event.actions.emplace_back(SendBlock{worker, block});
}

void BlockDirector::fetch(
    WorkerId worker, TreeId tree, std::vector<RootIndex> roots, WorkerId source, Event& event) {
    const FetchId id = ++fetch_last_;
    Fetch& begun =
        fetches_
            .emplace(id,
                     Fetch{worker, source, {}, roots.size(), event.now + limits::peer_fetch_max})
            .first->second;
    ++peers_.at(source).uploads;
    note_places(source);
    for (const RootIndex root : roots) {
        const BlockKey block{tree, root};
        forget_delivery(worker, block, event);
        Block& wanted = blocks_[block];
        wanted.on_the_way_to.insert(worker);
        peers_.at(worker).comes.emplace(block, id);
    }
    std::vector<WorkerId> sources{source};
    std::size_t looked_at = 0;
    for (const WorkerId other : blocks_.at({tree, roots.front()}).holders) {
        if (sources.size() == limits::peer_sources_max ||
            ++looked_at > limits::sources_looked_at_max) {
            break;
        }
        const bool has_all =
            mutated(Mutation::OthersSourceNamed) || std::ranges::all_of(roots, [&](RootIndex root) {
                return blocks_.at({tree, root}).holders.contains(other);
            });
        if (other != source && has_all && can_serve(other, worker)) {
            sources.push_back(other);
        }
    }
    begun.named = sources;
    event.actions.emplace_back(SendToPeers{worker, tree, std::move(roots), std::move(sources)});
}

void BlockDirector::forget_delivery(WorkerId worker, const BlockKey& block, Event& event) {
    Peer& peer = peers_.at(worker);
    const auto known = blocks_.find(block);
    if (const auto comes = peer.comes.find(block); comes != peer.comes.end()) {
        const FetchId id = comes->second;
        peer.comes.erase(comes);
        known->second.on_the_way_to.erase(worker);
        event.less_hope.insert(block);
        if (const auto fetch = fetches_.find(id);
            fetch != fetches_.end() && --fetch->second.left == 0) {
            free_place(fetch->second, event);
            fetches_.erase(fetch);
        }
    }
    stop_waiting(worker, block);
}

void BlockDirector::free_place(Fetch& fetch, Event& event) {
    if (const auto source = peers_.find(fetch.source); source != peers_.end()) {
        --source->second.uploads;
        note_places(fetch.source);
        event.have_places.insert(fetch.source);
    }
    fetch.source = {};
}

void BlockDirector::add_hold(WorkerId worker, const BlockKey& block) {
    Peer& peer = peers_.at(worker);
    if (!peer.serves) {
        return; // Peers cannot fetch from this worker.
    }
    Block& held = blocks_[block];
    peer.holds.insert(block);
    held.holders.insert(worker);
    if (!held.awaited_by.empty()) {
        peer.could_give.insert(block);
    }
}

void BlockDirector::serves_fewer(WorkerId source, Event& event) {
    const Peer& peer = peers_.at(source);
    note_places(source);
    event.less_hope.insert(peer.holds.begin(), peer.holds.end());
    for (const auto& [block, fetch] : peer.comes) {
        event.less_hope.insert(block);
    }
}

void BlockDirector::lose_hold(WorkerId worker, const BlockKey& block, Event& event) {
    const auto peer = peers_.find(worker);
    if (peer != peers_.end() && peer->second.holds.erase(block) != 0) {
        peer->second.could_give.erase(block);
        blocks_.at(block).holders.erase(worker);
        event.less_hope.insert(block);
    }
}

void BlockDirector::forget_if_unused(const BlockKey& block) {
    const auto found = blocks_.find(block);
    if (found != blocks_.end() && found->second.holders.empty() &&
        found->second.on_the_way_to.empty() && found->second.awaited_by.empty()) {
        blocks_.erase(found);
    }
}

} // namespace cd
