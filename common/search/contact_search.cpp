#include "common/search/contact_search.hpp"

#include "common/search/binary_search.hpp"
#include "common/search/wide_search.hpp"

namespace cd {

std::unique_ptr<ContactSearch> make_search(const TreeView& a,
                                           const TreeView& b,
                                           const PosePair& poses,
                                           std::span<const IgnoredRange> ignored,
                                           const SearchOptions& options) {
    if (!a.wide.nodes.empty() && !b.wide.nodes.empty()) {
        return std::make_unique<WideSearch>(poses, ignored, options);
    }
    return std::make_unique<BinarySearch>(poses, ignored, options);
}

std::vector<ContactPair> contact_pairs(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    const auto search = make_search(a.view(), b.view(), poses);
    search->collect(a.view(), b.view());
    search->contacts().sort();
    return search->contacts().take_pairs();
}

} // namespace cd
