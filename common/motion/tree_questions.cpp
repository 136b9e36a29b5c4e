#include "common/motion/tree_questions.hpp"

#include <utility>

namespace cd {

template <class IsFound>
bool TreeQuestions::ask(const PosePair& poses, double clearance, const IsFound& is_found) {
    search_.set_clearance(clearance);
    search_.restart(poses);
    spheres_.place(poses, clearance);
    const auto has_one = [&](std::size_t i) {
        return spheres_.may_be_within(i) && is_found(pairs_[i]);
    };
    bool has_found = !pairs_.empty() && has_one(last_);
    for (std::size_t i = 0; i < pairs_.size() && !has_found; ++i) {
        if (i != last_ && has_one(i)) {
            has_found = true;
            last_ = i;
        }
    }
    statistics_ += search_.report().statistics;
    return has_found;
}

bool TreeQuestions::is_within(const PosePair& poses, double distance) {
    return ask(poses, distance, [&](const SubtreePair& pair) {
        return search_.any_near(pair.a, pair.b) != Nearness::Far;
    });
}

bool TreeQuestions::is_contact(const PosePair& poses) {
    return ask(poses, clearance_.value_or(0), [&](const SubtreePair& pair) {
        return search_.any(pair.a, pair.b);
    });
}

CellQuestions TreeQuestions::for_cells(StopCheck stop) {
    return {[this](const PosePair& poses, double distance) { return is_within(poses, distance); },
            [this](const PosePair& poses) { return is_event(poses); },
            std::move(stop)};
}

} // namespace cd
