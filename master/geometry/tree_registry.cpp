#include "master/geometry/tree_registry.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"

namespace cd {

namespace {

/// Returns a hash over the form and the blocks of all distribution roots, which identifies the cut.
Sha256 name_of(const Cut& geometry) {
    ByteWriter out;
    out.put(static_cast<std::uint8_t>(geometry.form()));
    for (RootIndex root = 0; root < geometry.root_count(); ++root) {
        put_hash(out, geometry.hash(root));
    }
    return sha256(out.bytes());
}

} // namespace

TreeId TreeRegistry::acquire(const Sha256& mesh, std::shared_ptr<const Cut> geometry) {
    const Key key{mesh, geometry->depth(), geometry->form()};
    const auto [place, is_new] = ids_.try_emplace(key, TreeId{last_ + 1});
    if (is_new) {
        ++last_;
        const Sha256 cut = name_of(*geometry);
        trees_.emplace(place->second, Used{key, std::move(geometry), cut, 0});
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

AddTree TreeRegistry::message(TreeId tree) const {
    const Used& used = trees_.at(tree);
    const Cut& geometry = *used.geometry;
    return {tree,
            geometry.form(),
            used.cut,
            geometry.hash(top_root),
            geometry.root_count(),
            geometry.triangle_count()};
}

std::vector<AddTree> TreeRegistry::messages() const {
    std::vector<AddTree> all;
    for (const auto& [tree, used] : trees_) {
        all.push_back(message(tree));
    }
    return all;
}

std::shared_ptr<const Cut> TreeRegistry::find(TreeId tree) const {
    const auto found = trees_.find(tree);
    return found == trees_.end() ? nullptr : found->second.geometry;
}

} // namespace cd
