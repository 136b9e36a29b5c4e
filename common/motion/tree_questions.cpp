#include "common/motion/tree_questions.hpp"

#include "common/search/contact_search.hpp"

#include <memory>
#include <optional>
#include <utility>

namespace cd {

CellQuestions tree_questions(const TreeView& a,
                             const TreeView& b,
                             const SearchOptions& options,
                             std::span<const IgnoredRange> ignored) {
    const std::optional<double> clearance = options.clearance;
    SearchOptions with_clearance = options;
    with_clearance.clearance = clearance.value_or(0);
    const std::shared_ptr<ContactSearch> search =
        make_search(a, b, PosePair{}, ignored, with_clearance);
    const auto is_within = [=](const PosePair& poses, double distance) {
        search->set_clearance(distance);
        search->restart(poses);
        return search->any_near(a, b) != Nearness::Far;
    };
    const auto is_event = [=](const PosePair& poses) {
        if (clearance) {
            return is_within(poses, *clearance);
        }
        search->restart(poses);
        return search->any(a, b);
    };
    return {is_within, is_event, options.stop};
}

} // namespace cd
