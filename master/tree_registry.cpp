#include "master/tree_registry.hpp"

#include "common/core/check.hpp"

namespace cd {

TreeId TreeRegistry::acquire(const Sha256& mesh, std::shared_ptr<const CutGeometry> geometry) {
    const Key key{mesh, geometry->depth(), geometry->form()};
    const auto [place, is_new] = ids_.try_emplace(key, TreeId{last_ + 1});
    if (is_new) {
        ++last_;
        trees_.emplace(place->second, Used{key, std::move(geometry), 0});
    }
    ++trees_.at(place->second).users;
    return place->second;
}

bool TreeRegistry::release(TreeId tree) {
    const auto found = trees_.find(tree);
    CD_CHECK(found != trees_.end());
    if (--found->second.users != 0) {
        return false;
    }
    ids_.erase(found->second.key);
    trees_.erase(found);
    return true;
}

std::shared_ptr<const CutGeometry> TreeRegistry::find(TreeId tree) const {
    const auto found = trees_.find(tree);
    return found == trees_.end() ? nullptr : found->second.geometry;
}

} // namespace cd
