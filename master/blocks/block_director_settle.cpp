// Settles events: gives waiting workers what is available now. Checks the director's invariants.
#include "common/core/check.hpp"
#include "common/core/limits/wire.hpp"
#include "master/blocks/block_director.hpp"

#include <algorithm>
#include <utility>

namespace cd {

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
        forget_if_unused(block);
    }
    return std::move(event.actions);
}

void BlockDirector::note_places(WorkerId source) {
    const Peer& peer = peers_.at(source);
    if (peer.serves && !peer.is_avoided && peer.uploads < limits::peer_uploads_max) {
        free_.insert(source);
    } else {
        free_.erase(source);
    }
}

WorkerId BlockDirector::next_for(WorkerId source) const {
    std::pair<PlaceInLine, WorkerId> first{};
    for (const BlockKey& block : peers_.at(source).could_give) {
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

void BlockDirector::offer(WorkerId source, Event& event) {
    while (free_.contains(source)) {
        const WorkerId worker = next_for(source);
        if (worker == WorkerId{}) {
            return;
        }
        std::map<TreeId, std::vector<RootIndex>> roots;
        for (const auto& [block, since] : peers_.at(worker).waits_for) {
            if (peers_.at(source).holds.contains(block)) {
                roots[block.tree].push_back(block.root);
            }
        }
        for (auto& [tree, of_tree] : roots) {
            if (!free_.contains(source)) {
                return;
            }
            fetch(worker, tree, std::move(of_tree), source, event);
        }
    }
}

void BlockDirector::rescue(const BlockKey& block, Event& event) {
    const auto found = blocks_.find(block);
    if (found == blocks_.end()) {
        return;
    }
    const auto awaited_by = found->second.awaited_by;
    for (const auto& [place, worker] : awaited_by) {
        if (!is_worth_waiting(found->second, worker)) {
            send_from_master(worker, block, event);
        }
    }
}

void BlockDirector::check_invariants() const {
    std::map<WorkerId, std::size_t> uploads;
    std::map<FetchId, std::size_t> left;
    std::size_t on_the_way = 0;
    std::size_t awaited = 0;
    for (const auto& [id, fetch] : fetches_) {
        ++uploads[fetch.source];
        CD_CHECK(fetch.left != 0);
    }
    for (const auto& [worker, peer] : peers_) {
        CD_CHECK(peer.uploads == uploads[worker]);
        CD_CHECK(peer.uploads <= limits::peer_uploads_max);
        const auto in_line = line_.find(peer.place);
        CD_CHECK(peer.waits_for.empty() != (in_line != line_.end() && in_line->second == worker));
        CD_CHECK(free_.contains(worker) ==
                 (peer.serves && !peer.is_avoided && peer.uploads < limits::peer_uploads_max));
        on_the_way += peer.comes.size();
        awaited += peer.waits_for.size();
        for (const auto& [block, id] : peer.comes) {
            CD_CHECK(blocks_.at(block).on_the_way_to.contains(worker));
            CD_CHECK(!peer.waits_for.contains(block));
            CD_CHECK(!peer.holds.contains(block));
            left[id] += 1;
        }
        for (const auto& [block, since] : peer.waits_for) {
            CD_CHECK(blocks_.at(block).awaited_by.at(peer.place) == worker);
            CD_CHECK(is_worth_waiting(blocks_.at(block),
                                      worker)); // Otherwise the worker would wait in vain.
        }
        for (const BlockKey& block : peer.holds) {
            const Block& held = blocks_.at(block);
            CD_CHECK(held.holders.contains(worker));
            CD_CHECK(held.awaited_by.empty() != peer.could_give.contains(block));
        }
        CD_CHECK(std::ranges::includes(peer.holds, peer.could_give));
    }
    for (const auto& [id, fetch] : fetches_) {
        CD_CHECK(left[id] == fetch.left);
    }
    for (const auto& [block, state] : blocks_) {
        on_the_way -= state.on_the_way_to.size();
        awaited -= state.awaited_by.size();
    }
    CD_CHECK(on_the_way == 0);
    CD_CHECK(awaited == 0);
}

} // namespace cd
