#include "master/blocks/block_director.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "master/base/mutation.hpp"

#include <algorithm>
#include <utility>

namespace cd {

// ---- Events -----------------------------------------------------------------------------------

void BlockDirector::worker_joined(WorkerId worker, bool serves) {
    index_.join(worker, serves);
}

BlockActions BlockDirector::worker_left(WorkerId worker, Time now) {
    const BlockIndex::Peer* found = index_.find(worker);
    if (found == nullptr) {
        return {};
    }
    Event event{now, {}, {}, {}};
    for (const BlockKey& block : BlockIndex::Blocks(found->holds)) {
        lose_hold(worker, block, event);
    }
    const auto comes = found->comes;
    for (const auto& [block, fetch] : comes) {
        forget_delivery(worker, block, event);
    }
    const auto waits_for = found->waits_for;
    for (const auto& [block, since] : waits_for) {
        forget_delivery(worker, block, event);
    }
    // Workers that fetch from the lost worker notice the loss and report it.
    for (auto& [id, fetch] : fetches_) {
        if (fetch.source == worker) {
            fetch.source = {};
        }
    }
    index_.leave(worker);
    return settle(std::move(event));
}

BlockActions
BlockDirector::wanted(WorkerId worker, TreeId tree, std::span<const RootIndex> roots, Time now) {
    Event event{now, {}, {}, {}};
    RootsBySource given;
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
        index_.add_hold(worker, block, now);
        // The worker now serves the workers that waited until it had the block, so none of them
        // has lost a source.
        if (index_.at(worker).holds.contains(block)) {
            event.less_hope.erase(block);
        }
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
    const BlockIndex::Peer* peer = index_.find(worker);
    if (peer == nullptr) {
        return {};
    }
    Event event{now, {}, {}, {}};
    bool was_named = false;
    for (const RootIndex root : roots) {
        const BlockKey block{tree, root};
        const auto comes = peer->comes.find(block);
        if (comes == peer->comes.end() || comes->second == 0) {
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
    if (was_named && index_.find(source) != nullptr &&
        (how == PeerOutcome::Unreachable || how == PeerOutcome::Damaged)) {
        index_.set_unreachable(source, worker);
        if (how == PeerOutcome::Damaged) {
            index_.avoid(source);
        }
        serves_fewer(source, event);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::not_reached(WorkerId source, Time now) {
    Event event{now, {}, {}, {}};
    if (index_.find(source) != nullptr) {
        index_.avoid(source);
        serves_fewer(source, event);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::tree_removed(TreeId tree, Time now) {
    Event event{now, {}, {}, {}};
    auto place = index_.blocks().lower_bound({tree, 0});
    while (place != index_.blocks().end() && place->first.tree == tree) {
        const BlockKey block = (place++)->first;
        for (const auto& peer : index_.peers()) {
            if (peer == nullptr) {
                continue;
            }
            index_.lose_hold(peer->id, block);
            index_.stop_waiting(peer->id, block);
            if (const auto fetch = index_.stop_sending(peer->id, block)) {
                end_part(*fetch, event);
            }
        }
        index_.forget_if_unused(block);
    }
    return settle(std::move(event));
}

BlockActions BlockDirector::time_is(Time now) {
    Event event{now, {}, {}, {}};
    send_what_does_not_spread(event);
    while (!fetches_.empty() && fetches_.begin()->second.deadline <= now) {
        const FetchId late = fetches_.begin()->first;
        const WorkerId worker = fetches_.begin()->second.to;
        const auto comes = index_.at(worker).comes;
        for (const auto& [block, fetch] : comes) {
            if (fetch == late) {
                send_from_master(worker, block, event);
            }
        }
    }
    return settle(std::move(event));
}

void BlockDirector::send_what_does_not_spread(Event& event) {
    std::vector<std::pair<WorkerId, BlockKey>> late;
    for (const auto& [block, state] : index_.awaited()) {
        if (event.now - state->last_spread < timing::peer_wait_max) {
            continue;
        }
        for (const auto& [place, worker] : state->awaited_by) {
            if (event.now - index_.at(worker).waits_for.at(block) >= timing::peer_wait_max) {
                late.emplace_back(worker, block);
            }
        }
    }
    for (const auto& [worker, block] : late) {
        send_from_master(worker, block, event);
    }
}

// ---- Questions --------------------------------------------------------------------------------

std::size_t BlockDirector::open() const {
    std::size_t open = 0;
    for (const auto& peer : index_.peers()) {
        open += peer == nullptr ? 0 : peer->comes.size() + peer->waits_for.size();
    }
    return open;
}

bool BlockDirector::is_avoided(WorkerId worker) const {
    const BlockIndex::Peer* peer = index_.find(worker);
    return peer != nullptr && peer->is_avoided;
}

WorkerId BlockDirector::first_source(const BlockIndex::Block& block,
                                     WorkerId worker,
                                     const RootsBySource& given) const {
    const bool are_few = given.size() < limits::sources_of_a_request_max;
    const WorkerId source =
        are_few ? new_source(block, worker, given) : given_source(block, worker, given);
    if (source != WorkerId{}) {
        return source;
    }
    return are_few ? given_source(block, worker, given) : new_source(block, worker, given);
}

WorkerId BlockDirector::new_source(const BlockIndex::Block& block,
                                   WorkerId worker,
                                   const RootsBySource& given) const {
    WorkerId best;
    std::size_t least = limits::peer_uploads_max;
    std::size_t looked_at = 0;
    const auto has_enough = [&] {
        return least == 0 || (best != WorkerId{} && looked_at >= limits::sources_looked_at_max);
    };
    const auto next = [&](BlockIndex::Slot from) {
        return index_.free().next_common(block.holders, from);
    };
    const auto look = [&](BlockIndex::Slot from, BlockIndex::Slot end) {
        for (auto slot = next(from); slot < end && !has_enough(); slot = next(slot + 1)) {
            ++looked_at;
            const BlockIndex::Peer& source = *index_.peers()[slot];
            if (source.uploads < least && !given.contains(source.id) &&
                BlockIndex::can_serve(source, worker)) {
                best = source.id;
                least = source.uploads;
            }
        }
    };
    // Each worker starts the search at its own slot, which spreads workers over the sources.
    const BlockIndex::Slot begin = index_.at(worker).slot;
    look(begin, SlotSet::none);
    look(0, begin);
    return best;
}

WorkerId BlockDirector::given_source(const BlockIndex::Block& block,
                                     WorkerId worker,
                                     const RootsBySource& given) const {
    WorkerId best;
    std::pair<std::size_t, std::size_t> best_load;
    for (const auto& [source, roots] : given) {
        const BlockIndex::Peer& peer = index_.at(source);
        const std::pair load{roots.size(), peer.uploads};
        if (block.holders.contains(peer.slot) && BlockIndex::can_serve(peer, worker) &&
            (best == WorkerId{} || load < best_load)) {
            best = source;
            best_load = load;
        }
    }
    return best;
}

// ---- Effects of an event on one block ---------------------------------------------------------

void BlockDirector::want(WorkerId worker,
                         const BlockKey& block,
                         RootsBySource& given,
                         Event& event) {
    const BlockIndex::Peer& peer = index_.at(worker);
    if (peer.waits_for.contains(block)) {
        return;
    }
    if (const auto comes = peer.comes.find(block); comes != peer.comes.end()) {
        if (comes->second != 0) { // Peers were to deliver the block and have failed.
            forget_delivery(worker, block, event);
            send_from_master(worker, block, event);
        }
        return;
    }
    lose_hold(worker, block, event); // A worker that wants a block does not hold it.
    const BlockIndex::Block& wanted = index_.known(block);
    if (const WorkerId source = first_source(wanted, worker, given); source != WorkerId{}) {
        given[source].push_back(block.root);
    } else if (index_.is_worth_waiting(wanted, worker)) {
        index_.wait(worker, block, event.now);
    } else {
        send_from_master(worker, block, event);
    }
}

void BlockDirector::send_from_master(WorkerId worker, const BlockKey& block, Event& event) {
    forget_delivery(worker, block, event);
    index_.send(worker, block, 0);
    if (mutated(Mutation::HeldWhenSent)) {
        index_.add_hold(worker, block, event.now);
    }
    event.actions.emplace_back(SendBlock{worker, block});
}

void BlockDirector::fetch(
    WorkerId worker, TreeId tree, std::vector<RootIndex> roots, WorkerId source, Event& event) {
    const FetchId id = ++fetch_last_;
    Fetch& begun =
        fetches_
            .emplace(id,
                     Fetch{worker, source, {}, roots.size(), event.now + timing::peer_fetch_max})
            .first->second;
    index_.add_upload(source);
    for (const RootIndex root : roots) {
        const BlockKey block{tree, root};
        forget_delivery(worker, block, event);
        index_.send(worker, block, id);
    }
    SlotSet have_all = index_.blocks().at({tree, roots.front()}).holders;
    if (!mutated(Mutation::OthersSourceNamed)) {
        for (const RootIndex root : roots) {
            have_all.intersect(index_.blocks().at({tree, root}).holders);
        }
    }
    std::vector<WorkerId> sources{source};
    for (auto slot = have_all.next(0);
         slot != SlotSet::none && sources.size() < limits::peer_sources_max;
         slot = have_all.next(slot + 1)) {
        const BlockIndex::Peer& other = *index_.peers()[slot];
        if (other.id != source && BlockIndex::can_serve(other, worker)) {
            sources.push_back(other.id);
        }
    }
    begun.named = sources;
    event.actions.emplace_back(SendToPeers{worker, tree, std::move(roots), std::move(sources)});
}

void BlockDirector::forget_delivery(WorkerId worker, const BlockKey& block, Event& event) {
    if (const auto fetch = index_.stop_sending(worker, block)) {
        event.less_hope.insert(block);
        end_part(*fetch, event);
    }
    index_.stop_waiting(worker, block);
}

void BlockDirector::end_part(FetchId id, Event& event) {
    if (const auto fetch = fetches_.find(id);
        fetch != fetches_.end() && --fetch->second.left == 0) {
        free_place(fetch->second, event);
        fetches_.erase(fetch);
    }
}

void BlockDirector::free_place(Fetch& fetch, Event& event) {
    if (index_.find(fetch.source) != nullptr) {
        index_.remove_upload(fetch.source);
        event.have_places.insert(fetch.source);
    }
    fetch.source = {};
}

void BlockDirector::serves_fewer(WorkerId source, Event& event) {
    const BlockIndex::Peer& peer = index_.at(source);
    event.less_hope.insert(peer.holds.begin(), peer.holds.end());
    for (const auto& [block, fetch] : peer.comes) {
        event.less_hope.insert(block);
    }
}

void BlockDirector::lose_hold(WorkerId worker, const BlockKey& block, Event& event) {
    if (index_.lose_hold(worker, block)) {
        event.less_hope.insert(block);
    }
}

// ---- The end of an event ------------------------------------------------------------------------

BlockActions BlockDirector::settle(Event event) {
    while (!event.have_places.empty()) {
        const WorkerId source = *event.have_places.begin();
        event.have_places.erase(event.have_places.begin());
        offer(source, event);
    }
    while (!event.less_hope.empty()) {
        const BlockKey block = *event.less_hope.begin();
        event.less_hope.erase(event.less_hope.begin());
        rescue(block, event);
        index_.forget_if_unused(block);
    }
    return std::move(event.actions);
}

void BlockDirector::offer(WorkerId source, Event& event) {
    const BlockIndex::Slot slot = index_.at(source).slot;
    while (index_.free().contains(slot)) {
        const WorkerId worker = index_.next_for(source);
        if (worker == WorkerId{}) {
            return;
        }
        std::map<TreeId, std::vector<RootIndex>> roots;
        for (const auto& [block, since] : index_.at(worker).waits_for) {
            if (index_.at(source).holds.contains(block)) {
                roots[block.tree].push_back(block.root);
            }
        }
        for (auto& [tree, of_tree] : roots) {
            if (!index_.free().contains(slot)) {
                return;
            }
            fetch(worker, tree, std::move(of_tree), source, event);
        }
    }
}

void BlockDirector::rescue(const BlockKey& block, Event& event) {
    const auto found = index_.blocks().find(block);
    if (found == index_.blocks().end()) {
        return;
    }
    std::vector<WorkerId> hopeless;
    for (const auto& [place, worker] : found->second.awaited_by) {
        if (!index_.is_worth_waiting(found->second, worker)) {
            hopeless.push_back(worker);
        }
    }
    for (const WorkerId worker : hopeless) {
        // The master may have begun to send the block to a worker that can serve this one.
        if (!index_.is_worth_waiting(found->second, worker)) {
            send_from_master(worker, block, event);
        }
    }
}

void BlockDirector::check_invariants() const {
    index_.check_invariants();
    std::map<WorkerId, std::size_t> uploads;
    std::map<FetchId, std::size_t> left;
    for (const auto& [id, fetch] : fetches_) {
        ++uploads[fetch.source];
        CD_CHECK(fetch.left != 0);
    }
    for (const auto& peer : index_.peers()) {
        if (peer == nullptr) {
            continue;
        }
        CD_CHECK(peer->uploads == uploads[peer->id]);
        for (const auto& [block, id] : peer->comes) {
            left[id] += 1;
        }
        for (const auto& [block, since] : peer->waits_for) {
            // No worker waits for a block that no peer can give.
            CD_CHECK(index_.is_worth_waiting(index_.blocks().at(block), peer->id));
        }
    }
    for (const auto& [id, fetch] : fetches_) {
        CD_CHECK(left[id] == fetch.left);
    }
}

} // namespace cd
