#include "common/motion/tree_questions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace cd {

TreeQuestions::TreeQuestions(ContactSearch& search,
                             std::span<const SubtreePair> pairs,
                             std::optional<double> clearance)
    : search_(search), pairs_(pairs), clearance_(clearance), live_(1, Live(pairs.size())) {
    std::iota(live_.front().begin(), live_.front().end(), 0u);
}

void TreeQuestions::prepare(const PosePair& poses, double clearance) {
    search_.set_clearance(clearance);
    search_.restart(poses);
}

template <class IsFound>
bool TreeQuestions::ask(const PosePair& poses,
                        double clearance,
                        Live& live,
                        const IsFound& is_found) {
    prepare(poses, clearance);
    const auto found = std::find_if(
        live.begin(), live.end(), [&](std::uint32_t pair) { return is_found(pairs_[pair]); });
    statistics_ += search_.report().statistics;
    if (found == live.end()) {
        return false;
    }
    std::iter_swap(live.begin(), found);
    return true;
}

bool TreeQuestions::is_within(const PosePair& poses, double distance) {
    return ask(poses, distance, live_[level_], [&](const SubtreePair& pair) {
        return search_.any_near(pair.a, pair.b) != Nearness::Far;
    });
}

bool TreeQuestions::is_contact(const PosePair& poses) {
    return ask(poses, clearance_.value_or(0), live_.front(), [&](const SubtreePair& pair) {
        return search_.any(pair.a, pair.b);
    });
}

bool TreeQuestions::is_event(const PosePair& poses) {
    if (clearance_) {
        return is_within(poses, *clearance_);
    }
    return ask(poses, 0, live_[level_], [&](const SubtreePair& pair) {
        return search_.any(pair.a, pair.b);
    });
}

void TreeQuestions::halve(const PosePair& poses, double distance) {
    live_.resize(level_ + 1);
    const Live& live = live_.back();
    const double farther = distance * (1 + 0x1p-20);
    if (live.size() == 1 || !std::isfinite(farther)) {
        live_.push_back(Live(live));
        return;
    }
    prepare(poses, farther);
    Live near;
    std::copy_if(live.begin(), live.end(), std::back_inserter(near), [&](std::uint32_t pair) {
        return search_.any_near(pairs_[pair].a, pairs_[pair].b) != Nearness::Far;
    });
    statistics_ += search_.report().statistics;
    live_.push_back(std::move(near));
}

CellQuestions TreeQuestions::for_cells(StopCheck stop) {
    return {[this](const PosePair& poses, double distance) { return is_within(poses, distance); },
            [this](const PosePair& poses) { return is_event(poses); },
            std::move(stop),
            [this](unsigned level) { level_ = level; },
            [this](const PosePair& poses, double distance) { halve(poses, distance); }};
}

} // namespace cd
