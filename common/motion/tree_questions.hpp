// Answers a motion's questions by a search of two whole trees.
#pragma once

#include "common/motion/cells.hpp"
#include "common/search/search_options.hpp"
#include "common/tree/ignored_range.hpp"
#include "common/tree/obb_tree.hpp"

#include <span>

namespace cd {

/// Returns questions that one search answers for both trees under any poses. The event is that of
/// `options.clearance`. The trees and `ignored` outlive the questions; one thread at a time may
/// ask.
[[nodiscard]] CellQuestions tree_questions(const TreeView& a,
                                           const TreeView& b,
                                           const SearchOptions& options = {},
                                           std::span<const IgnoredRange> ignored = {});

} // namespace cd
