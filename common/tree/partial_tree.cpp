#include "common/tree/partial_tree.hpp"

namespace cd {

std::vector<RootIndex> PartialObbTree::missing(std::span<const RootIndex> roots) const {
    std::vector<RootIndex> missing;
    for (const RootIndex root : roots) {
        if (!slots_[root]) {
            missing.push_back(root);
        }
    }
    return missing;
}

} // namespace cd
