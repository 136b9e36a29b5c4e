#include "master/blocks/block_index.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <algorithm>
#include <utility>

namespace cd {

// ---- Workers ------------------------------------------------------------------------------------

void BlockIndex::join(WorkerId worker, bool serves) {
    CD_CHECK(!slots_.contains(worker));
    if (slots_left_.empty()) {
        slots_left_.push_back(static_cast<Slot>(peers_.size()));
        peers_.emplace_back();
    }
    auto joined = std::make_unique<Peer>();
    joined->id = worker;
    joined->slot = slots_left_.back();
    joined->serves = serves;
    servers_ += serves ? 1 : 0;
    slots_left_.pop_back();
    slots_.emplace(worker, joined->slot);
    note_places(*joined);
    peers_[joined->slot] = std::move(joined);
}

void BlockIndex::leave(WorkerId worker) {
    const auto found = slots_.find(worker);
    const Slot slot = found->second;
    servers_ -= peers_[slot]->serves ? 1 : 0;
    free_.erase(slot);
    peers_[slot].reset();
    slots_left_.push_back(slot);
    slots_.erase(found);
}

const BlockIndex::Peer* BlockIndex::find(WorkerId worker) const {
    const auto found = slots_.find(worker);
    return found == slots_.end() ? nullptr : peers_[found->second].get();
}

bool BlockIndex::can_serve(WorkerId source, WorkerId worker) const {
    const Peer* peer = find(source);
    return peer != nullptr && can_serve(*peer, worker);
}

bool BlockIndex::can_serve(const Peer& source, WorkerId worker) {
    return source.id != worker && source.serves && !source.is_avoided &&
           !source.cannot_reach_it.contains(worker);
}

bool BlockIndex::is_worth_waiting(const Block& block, WorkerId worker) const {
    return servers_ != 0 &&
           (has_source(block.holders, worker) || has_source(block.on_the_way_to, worker));
}

bool BlockIndex::has_source(const SlotSet& sources, WorkerId worker) const {
    Slot slot = sources.next(0);
    while (slot != SlotSet::none && !can_serve(*peers_[slot], worker)) {
        slot = sources.next(slot + 1);
    }
    return slot != SlotSet::none;
}

bool BlockIndex::has_place(const Peer& peer) {
    return peer.serves && !peer.is_avoided && peer.uploads < limits::peer_uploads_max;
}

void BlockIndex::note_places(const Peer& source) {
    if (has_place(source)) {
        free_.insert(source.slot);
    } else {
        free_.erase(source.slot);
    }
}

void BlockIndex::add_upload(WorkerId source) {
    Peer& busier = peer(source);
    ++busier.uploads;
    note_places(busier);
}

void BlockIndex::remove_upload(WorkerId source) {
    Peer& freer = peer(source);
    --freer.uploads;
    note_places(freer);
}

void BlockIndex::set_unreachable(WorkerId source, WorkerId by) {
    Peer& unreached = peer(source);
    unreached.cannot_reach_it.insert(by);
    unreached.is_avoided |= unreached.cannot_reach_it.size() >= limits::peer_unreachable_by_max;
    note_places(unreached);
}

void BlockIndex::avoid(WorkerId source) {
    Peer& avoided = peer(source);
    avoided.is_avoided = true;
    note_places(avoided);
}

// ---- Blocks -------------------------------------------------------------------------------------

void BlockIndex::forget_if_unused(const BlockKey& block) {
    const auto found = blocks_.find(block);
    if (found != blocks_.end() && found->second.holders.empty() &&
        found->second.on_the_way_to.empty() && found->second.awaited_by.empty()) {
        blocks_.erase(found);
    }
}

void BlockIndex::add_hold(WorkerId worker, const BlockKey& block, Time now) {
    Peer& holder = peer(worker);
    if (!holder.serves) {
        return;
    }
    holder.holds.insert(block);
    Block& held = blocks_[block];
    held.holders.insert(holder.slot);
    held.last_spread = now;
}

bool BlockIndex::lose_hold(WorkerId worker, const BlockKey& block) {
    const auto slot = slots_.find(worker);
    if (slot == slots_.end() || peers_[slot->second]->holds.erase(block) == 0) {
        return false;
    }
    blocks_.at(block).holders.erase(slot->second);
    return true;
}

void BlockIndex::wait(WorkerId worker, const BlockKey& block, Time now) {
    Peer& waiter = peer(worker);
    if (waiter.waits_for.empty()) {
        waiter.place = ++place_last_;
    }
    waiter.waits_for.emplace(block, now);
    Block& awaited = blocks_.at(block);
    awaited.awaited_by.emplace(waiter.place, worker);
    awaited_.emplace(block, &awaited);
}

void BlockIndex::stop_waiting(WorkerId worker, const BlockKey& block) {
    Peer& waiter = peer(worker);
    if (waiter.waits_for.erase(block) == 0) {
        return;
    }
    Block& awaited = blocks_.at(block);
    awaited.awaited_by.erase(waiter.place);
    if (awaited.awaited_by.empty()) {
        awaited_.erase(block);
    }
}

void BlockIndex::send(WorkerId worker, const BlockKey& block, FetchId fetch) {
    Peer& to = peer(worker);
    to.comes.emplace(block, fetch);
    blocks_[block].on_the_way_to.insert(to.slot);
}

std::optional<BlockIndex::FetchId> BlockIndex::stop_sending(WorkerId worker,
                                                            const BlockKey& block) {
    Peer& to = peer(worker);
    const auto found = to.comes.find(block);
    if (found == to.comes.end()) {
        return std::nullopt;
    }
    const FetchId fetch = found->second;
    to.comes.erase(found);
    blocks_.at(block).on_the_way_to.erase(to.slot);
    return fetch;
}

WorkerId BlockIndex::next_for(WorkerId source) const {
    const Peer& giver = at(source);
    std::pair<PlaceInLine, WorkerId> first{};
    auto held = giver.holds.begin();
    for (const auto& [block, awaited] : awaited_) {
        while (held != giver.holds.end() && *held < block) {
            ++held;
        }
        if (held == giver.holds.end()) {
            break;
        }
        if (*held != block) {
            continue;
        }
        for (const auto& [place, worker] : awaited->awaited_by) {
            if (first.first != 0 && first.first <= place) {
                break;
            }
            if (can_serve(giver, worker)) {
                first = {place, worker};
                break;
            }
        }
    }
    return first.second;
}

void BlockIndex::check_invariants() const {
    std::size_t on_the_way = 0;
    std::size_t awaited = 0;
    CD_CHECK(slots_.size() + slots_left_.size() == peers_.size());
    for (const auto& [worker, slot] : slots_) {
        const Peer& peer = *peers_[slot];
        CD_CHECK(peer.id == worker && peer.slot == slot);
        CD_CHECK(peer.uploads <= limits::peer_uploads_max);
        CD_CHECK(free_.contains(slot) == has_place(peer));
        on_the_way += peer.comes.size();
        awaited += peer.waits_for.size();
        for (const auto& [block, id] : peer.comes) {
            CD_CHECK(blocks_.at(block).on_the_way_to.contains(slot));
            CD_CHECK(!peer.waits_for.contains(block));
            CD_CHECK(!peer.holds.contains(block));
        }
        for (const auto& [block, since] : peer.waits_for) {
            CD_CHECK(blocks_.at(block).awaited_by.at(peer.place) == worker);
        }
        for (const BlockKey& block : peer.holds) {
            CD_CHECK(blocks_.at(block).holders.contains(slot));
        }
    }
    for (const auto& [block, state] : blocks_) {
        on_the_way -= state.on_the_way_to.size();
        awaited -= state.awaited_by.size();
        const auto awaits = awaited_.find(block);
        CD_CHECK((awaits != awaited_.end()) != state.awaited_by.empty());
        CD_CHECK(awaits == awaited_.end() || awaits->second == &state);
    }
    CD_CHECK(on_the_way == 0);
    CD_CHECK(awaited == 0);
}

} // namespace cd
