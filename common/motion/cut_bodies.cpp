#include "common/motion/cut_bodies.hpp"

namespace cd {

std::optional<SubtreePair> CutBodies::subtrees(const RootPair& roots) const {
    const Subtree* const a = a_.subtree(roots.a);
    const Subtree* const b = b_.subtree(roots.b);
    if (a == nullptr || b == nullptr) {
        return std::nullopt;
    }
    return SubtreePair{a->view(), b->view()};
}

std::uint64_t CutBodies::visit_within(
    const PosePair& poses,
    double distance,
    const std::function<bool(const RootPair&, const SubtreePair&)>& visit) const {
    return visit_colliding_roots(a_.top, b_.top, poses, distance, [&](const RootPair& roots) {
        const auto pair = subtrees(roots);
        return !pair || visit(roots, *pair);
    });
}

} // namespace cd
