// Gives the cut trees of running jobs the ids by which messages to workers name them.
#pragma once

#include "common/core/files/hash.hpp"
#include "master/geometry/cut.hpp"
#include "proto/messages/work_messages.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace cd {

/// Jobs that use one mesh at one depth in one form share an id. Ids are not reused while the master
/// runs.
class TreeRegistry {
  public:
    /// Adds a user of the tree, and returns the tree's id.
    TreeId acquire(const Sha256& mesh, std::shared_ptr<const Cut> geometry);
    /// Removes a user of the tree. Returns true if this was the last user, so that the tree is
    /// dropped.
    bool release(TreeId tree);

    /// The message that makes a tree known to a worker. Its hash of the cut does not change when
    /// the master restarts.
    [[nodiscard]] AddTree message(TreeId tree) const;
    /// The messages of all used trees.
    [[nodiscard]] std::vector<AddTree> messages() const;
    /// Null for a tree without users.
    [[nodiscard]] std::shared_ptr<const Cut> find(TreeId tree) const;

  private:
    using Key = std::tuple<Sha256, std::uint32_t, SubtreeForm>;
    struct Used {
        Key key;
        std::shared_ptr<const Cut> geometry;
        Sha256 cut;
        std::uint64_t users = 0;
    };
    std::map<Key, TreeId> ids_;
    std::map<TreeId, Used> trees_;
    std::uint64_t last_ = 0;
};

} // namespace cd
