#include "master/jobs/place_queue.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace cd {

std::vector<PlaceRange> without(std::span<const PlaceRange> runs, const PlaceRange& hole) {
    std::vector<PlaceRange> rest;
    for (const PlaceRange& run : runs) {
        const std::uint64_t before = std::clamp(hole.first, run.first, run.end());
        const std::uint64_t after = std::clamp(hole.end(), before, run.end());
        for (const PlaceRange& part :
             {PlaceRange{run.first, before - run.first}, PlaceRange{after, run.end() - after}}) {
            if (part.count != 0) {
                rest.push_back(part);
            }
        }
    }
    return rest;
}

PlaceQueue::PlaceQueue(std::uint64_t scenarios, std::span<const LostPlaces> lost)
    : left_(scenarios) {
    // Key: first position of a piece, which ends where the next piece begins.
    std::map<std::uint64_t, Losses> pieces;
    pieces[0];
    const auto begin_at = [&](std::uint64_t place) {
        return pieces.emplace(place, std::prev(pieces.upper_bound(place))->second).first;
    };
    for (const LostPlaces& one : lost) {
        const auto first = begin_at(one.places.first);
        const auto end = begin_at(one.places.end());
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

PlaceQueue::Piece PlaceQueue::take(std::uint64_t most) {
    CD_CHECK(!empty() && most != 0);
    Piece& front = pieces_.front();
    const std::uint64_t window = limits::order_window_scenarios;
    const std::uint64_t window_end = front.places.first - front.places.first % window + window;
    const std::uint64_t count =
        std::min({most, front.places.count, window_end - front.places.first});
    const Piece taken{{front.places.first, count}, front.losses};
    left_ -= count;
    front.places = {taken.places.end(), front.places.count - count};
    if (front.places.count == 0) {
        pieces_.pop_front();
    }
    return taken;
}

void PlaceQueue::put_back(const Piece& piece) {
    CD_CHECK(piece.places.count != 0);
    pieces_.push_front(piece);
    left_ += piece.places.count;
}

} // namespace cd
