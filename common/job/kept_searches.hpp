// Keeps contact searches for further scenarios of the same trees.
#pragma once

#include "common/core/limits/engine.hpp"
#include "common/job/shots/bundle_shots.hpp"
#include "common/search/contact_search.hpp"
#include "common/shots/segment_hit.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cd {

/// A contact search whose memory further scenarios of one query and the same two trees reuse.
struct KeptSearch {
    std::unique_ptr<ContactSearch> search; ///< Created by the first scenario with a pair.
    /// Index of the pair in which the last run at `level any` found a contact; empty without one.
    std::optional<std::size_t> touching;
    std::optional<BundleShots> bundles; ///< With Question::Shots; created by the first scenario.
    std::optional<SegmentHit> lines;    ///< With Question::Shots; created by the first hit.
};

/// One search for each pair of trees, of at most `limits::searches_kept_max` pairs: those used
/// last. `Tree` names a tree.
template <class Tree>
class KeptSearches {
  public:
    /// Returns the search of two trees, which is new if it was not kept. It is valid until the next
    /// call.
    [[nodiscard]] KeptSearch& of(const Tree& a, const Tree& b) {
        const std::pair trees(a, b);
        auto found = std::ranges::find(kept_, trees, &Entry::trees);
        if (found == kept_.end()) {
            if (kept_.size() == limits::searches_kept_max) {
                kept_.pop_back();
            }
            found = kept_.insert(kept_.end(), Entry{trees, {}});
        }
        std::rotate(kept_.begin(), found, found + 1);
        return kept_.front().search;
    }

  private:
    struct Entry {
        std::pair<Tree, Tree> trees;
        KeptSearch search;
    };
    std::vector<Entry> kept_; ///< The pair used last is first.
};

} // namespace cd
