#include "master/dispatch/dispatch_tree.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

TreeId id_of(const DispatchTrees::Tree& tree) {
    return tree->tree;
}

} // namespace

DispatchTrees::DispatchTrees(std::vector<Tree> by_body)
    : by_body_(std::move(by_body)), distinct_(by_body_) {
    std::ranges::sort(distinct_, {}, id_of);
    const auto doubles = std::ranges::unique(distinct_, {}, id_of);
    distinct_.erase(doubles.begin(), doubles.end());
}

DispatchTrees::DispatchTrees(DispatchTree a, DispatchTree b)
    : DispatchTrees({std::make_shared<const DispatchTree>(std::move(a)),
                     std::make_shared<const DispatchTree>(std::move(b))}) {}

bool DispatchTrees::have(TreeId tree) const {
    return std::ranges::binary_search(distinct_, tree, {}, id_of);
}

} // namespace cd
