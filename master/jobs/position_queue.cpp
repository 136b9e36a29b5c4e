#include "master/jobs/position_queue.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace cd {

PositionQueue::PositionQueue(std::uint64_t scenarios, std::span<const LostPositions> lost)
    : left_(scenarios) {
    // Key: first position of a piece, which ends where the next piece begins.
    std::map<std::uint64_t, Losses> pieces;
    pieces[0];
    const auto begin_at = [&](std::uint64_t position) {
        return pieces.emplace(position, std::prev(pieces.upper_bound(position))->second).first;
    };
    for (const LostPositions& one : lost) {
        const auto first = begin_at(one.positions.first);
        const auto end = begin_at(one.positions.end());
        for (auto piece = first; piece != end; ++piece) {
            piece->second.add(one.process);
        }
    }
    pieces.erase(scenarios);
    for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
        const auto next = std::next(piece);
        const std::uint64_t end = next == pieces.end() ? scenarios : next->first;
        pieces_.push_back({{piece->first, end - piece->first}, piece->second});
    }
}

PositionQueue::Piece PositionQueue::take(std::uint64_t most) {
    CD_CHECK(!empty() && most != 0);
    Piece& front = pieces_.front();
    const std::uint64_t window = limits::order_window_scenarios;
    const std::uint64_t window_end =
        front.positions.first - front.positions.first % window + window;
    const std::uint64_t count =
        std::min({most, front.positions.count, window_end - front.positions.first});
    const Piece taken{{front.positions.first, count}, front.losses};
    left_ -= count;
    front.positions = {taken.positions.end(), front.positions.count - count};
    if (front.positions.count == 0) {
        pieces_.pop_front();
    }
    return taken;
}

void PositionQueue::put_back(const Piece& piece) {
    CD_CHECK(piece.positions.count != 0);
    pieces_.push_front(piece);
    left_ += piece.positions.count;
}

} // namespace cd
