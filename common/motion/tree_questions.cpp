#include "common/motion/tree_questions.hpp"

#include <utility>

namespace cd {

template <class IsFound>
bool TreeQuestions::ask(const PosePair& poses, double clearance, const IsFound& is_found) {
    search_.set_clearance(clearance);
    search_.restart(poses);
    const auto* const whole = std::get_if<SubtreePair>(&trees_);
    const bool has_found =
        whole != nullptr
            ? is_found(*whole)
            : ask_roots(*std::get<const CutBodies*>(trees_), poses, clearance, is_found);
    statistics_ += search_.report().statistics;
    return has_found;
}

template <class IsFound>
bool TreeQuestions::ask_roots(const CutBodies& bodies,
                              const PosePair& poses,
                              double distance,
                              const IsFound& is_found) {
    if (last_ && is_found(*bodies.subtrees(*last_))) {
        return true;
    }
    bool has_found = false;
    statistics_.box_tests += bodies.visit_within(
        poses, distance, [&](const RootPair& roots, const SubtreePair& subtrees) {
            if (roots != last_ && is_found(subtrees)) {
                has_found = true;
                last_ = roots;
            }
            return !has_found;
        });
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
