#include "worker/session/tree_joiner.hpp"

#include <algorithm>

namespace cd {

void TreeJoiner::prepare(Walk& walk) {
    const std::uint64_t left = cache_.bytes_max() - std::min(cache_.bytes(), cache_.bytes_max());
    trees_.keep_within(left);
    for (const auto& [tree, blocks] : walk.trees) {
        if (auto joined = trees_.find(blocks)) {
            walk.joined.emplace(tree, std::move(joined));
        }
        if (const auto step = trees_.count(blocks, left)) {
            start(*step);
        }
    }
}

void TreeJoiner::start(const JoinedTrees::Step& step) {
    hub_.run_on_thread(
        [this, step] { return [this, step, joined = step.run()] { trees_.end(step, joined); }; });
}

} // namespace cd
