// The cut trees that running jobs use, under the numbers by which workers know them.
#pragma once

#include "common/core/files/hash.hpp"
#include "master/geometry/cut_geometry.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace cd {

/// Jobs that use the same mesh at the same depth in the same form share a number. A number is never
/// used again.
class TreeRegistry {
  public:
    /// One more user of the tree.
    TreeId acquire(const Sha256& mesh, std::shared_ptr<const CutGeometry> geometry);
    /// One user less. True when that was the last one: the tree is gone.
    bool release(TreeId tree);

    /// The name of the tree's cut, the same in every life of the master. The tree is used.
    [[nodiscard]] const Sha256& cut(TreeId tree) const { return trees_.at(tree).cut; }
    /// The trees that are used.
    [[nodiscard]] std::vector<TreeId> all() const;
    /// Null for a tree that nobody uses (any more).
    [[nodiscard]] std::shared_ptr<const CutGeometry> find(TreeId tree) const;

  private:
    using Key = std::tuple<Sha256, std::uint32_t, SubtreeForm>;
    struct Used {
        Key key;
        std::shared_ptr<const CutGeometry> geometry;
        Sha256 cut;
        std::uint64_t users = 0;
    };
    std::map<Key, TreeId> ids_;
    std::map<TreeId, Used> trees_;
    std::uint64_t last_ = 0;
};

} // namespace cd
