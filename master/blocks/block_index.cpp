#include "master/blocks/block_index.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"

#include <algorithm>
#include <utility>

namespace cd {

// ---- Workers ------------------------------------------------------------------------------------

void BlockIndex::join(WorkerId worker, bool serves) {
    const auto [place, is_new] = peers_.try_emplace(worker);
    CD_CHECK(is_new);
    place->second.serves = serves;
    servers_ += serves ? 1 : 0;
    note_places(worker);
}

void BlockIndex::leave(WorkerId worker) {
    const auto found = peers_.find(worker);
    servers_ -= found->second.serves ? 1 : 0;
    peers_.erase(found);
    free_.erase(worker);
}

const BlockIndex::Peer* BlockIndex::find(WorkerId worker) const {
    const auto found = peers_.find(worker);
    return found == peers_.end() ? nullptr : &found->second;
}

bool BlockIndex::can_serve(WorkerId source, WorkerId worker) const {
    const Peer* peer = find(source);
    return source != worker && peer != nullptr && peer->serves && !peer->is_avoided &&
           !peer->cannot_reach_it.contains(worker);
}

bool BlockIndex::is_worth_waiting(const Block& block, WorkerId worker) const {
    const auto serves = [&](WorkerId other) { return can_serve(other, worker); };
    return servers_ != 0 && (std::ranges::any_of(block.holders, serves) ||
                             std::ranges::any_of(block.on_the_way_to, serves));
}

bool BlockIndex::has_place(const Peer& peer) {
    return peer.serves && !peer.is_avoided && peer.uploads < limits::peer_uploads_max;
}

void BlockIndex::note_places(WorkerId source) {
    if (has_place(peers_.at(source))) {
        free_.insert(source);
    } else {
        free_.erase(source);
    }
}

void BlockIndex::add_upload(WorkerId source) {
    ++peers_.at(source).uploads;
    note_places(source);
}

void BlockIndex::remove_upload(WorkerId source) {
    --peers_.at(source).uploads;
    note_places(source);
}

void BlockIndex::set_unreachable(WorkerId source, WorkerId by) {
    Peer& peer = peers_.at(source);
    peer.cannot_reach_it.insert(by);
    peer.is_avoided |= peer.cannot_reach_it.size() >= limits::peer_unreachable_by_max;
    note_places(source);
}

void BlockIndex::avoid(WorkerId source) {
    peers_.at(source).is_avoided = true;
    note_places(source);
}

// ---- Blocks -------------------------------------------------------------------------------------

void BlockIndex::forget_if_unused(const BlockKey& block) {
    const auto found = blocks_.find(block);
    if (found != blocks_.end() && found->second.holders.empty() &&
        found->second.on_the_way_to.empty() && found->second.awaited_by.empty()) {
        blocks_.erase(found);
    }
}

void BlockIndex::add_hold(WorkerId worker, const BlockKey& block) {
    Peer& peer = peers_.at(worker);
    if (!peer.serves) {
        return;
    }
    peer.holds.insert(block);
    blocks_[block].holders.insert(worker);
}

bool BlockIndex::lose_hold(WorkerId worker, const BlockKey& block) {
    const auto peer = peers_.find(worker);
    if (peer == peers_.end() || peer->second.holds.erase(block) == 0) {
        return false;
    }
    blocks_.at(block).holders.erase(worker);
    return true;
}

void BlockIndex::wait(WorkerId worker, const BlockKey& block, Time now) {
    Peer& peer = peers_.at(worker);
    if (peer.waits_for.empty()) {
        peer.place = ++place_last_;
        line_.emplace(peer.place, worker);
    }
    peer.waits_for.emplace(block, now);
    Block& awaited = blocks_.at(block);
    awaited.awaited_by.emplace(peer.place, worker);
    awaited_.insert(block);
}

void BlockIndex::stop_waiting(WorkerId worker, const BlockKey& block) {
    Peer& peer = peers_.at(worker);
    if (peer.waits_for.erase(block) == 0) {
        return;
    }
    Block& awaited = blocks_.at(block);
    awaited.awaited_by.erase(peer.place);
    if (awaited.awaited_by.empty()) {
        awaited_.erase(block);
    }
    if (peer.waits_for.empty()) {
        line_.erase(peer.place);
    }
}

void BlockIndex::send(WorkerId worker, const BlockKey& block, FetchId fetch) {
    peers_.at(worker).comes.emplace(block, fetch);
    blocks_[block].on_the_way_to.insert(worker);
}

std::optional<BlockIndex::FetchId> BlockIndex::stop_sending(WorkerId worker,
                                                            const BlockKey& block) {
    std::map<BlockKey, FetchId>& comes = peers_.at(worker).comes;
    const auto found = comes.find(block);
    if (found == comes.end()) {
        return std::nullopt;
    }
    const FetchId fetch = found->second;
    comes.erase(found);
    blocks_.at(block).on_the_way_to.erase(worker);
    return fetch;
}

WorkerId BlockIndex::next_for(WorkerId source) const {
    std::pair<PlaceInLine, WorkerId> first{};
    const Blocks& holds = peers_.at(source).holds;
    const bool are_few = awaited_.size() < holds.size();
    for (const BlockKey& block : are_few ? awaited_ : holds) {
        if (!(are_few ? holds : awaited_).contains(block)) {
            continue;
        }
        for (const auto& [place, worker] : blocks_.at(block).awaited_by) {
            if (first.first != 0 && first.first <= place) {
                break;
            }
            if (can_serve(source, worker)) {
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
    for (const auto& [worker, peer] : peers_) {
        CD_CHECK(peer.uploads <= limits::peer_uploads_max);
        const auto in_line = line_.find(peer.place);
        CD_CHECK(peer.waits_for.empty() != (in_line != line_.end() && in_line->second == worker));
        CD_CHECK(free_.contains(worker) == has_place(peer));
        on_the_way += peer.comes.size();
        awaited += peer.waits_for.size();
        for (const auto& [block, id] : peer.comes) {
            CD_CHECK(blocks_.at(block).on_the_way_to.contains(worker));
            CD_CHECK(!peer.waits_for.contains(block));
            CD_CHECK(!peer.holds.contains(block));
        }
        for (const auto& [block, since] : peer.waits_for) {
            CD_CHECK(blocks_.at(block).awaited_by.at(peer.place) == worker);
        }
        for (const BlockKey& block : peer.holds) {
            CD_CHECK(blocks_.at(block).holders.contains(worker));
        }
    }
    for (const auto& [block, state] : blocks_) {
        on_the_way -= state.on_the_way_to.size();
        awaited -= state.awaited_by.size();
        CD_CHECK(awaited_.contains(block) != state.awaited_by.empty());
    }
    CD_CHECK(on_the_way == 0);
    CD_CHECK(awaited == 0);
}

} // namespace cd
