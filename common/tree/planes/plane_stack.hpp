// The pairs of nodes of a descent that planes may part.
#pragma once

#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/wide/pair_buckets.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// A stack of pairs of nodes, each with the normal that its parents' plane had. Keeps its memory.
class PlaneStack {
  public:
    /// Forgets all pairs and takes other trees, which have support points and outlive the calls.
    void reset(const PlanePose& pose, const WideView& a, const WideView& b);
    void push_roots();
    void clear() { pairs_.clear(); }
    [[nodiscard]] std::size_t size() const { return pairs_.size(); }

    /// Takes pairs off the stack until one cannot be parted; returns it, or nothing if no pair is
    /// left.
    [[nodiscard]] std::optional<WidePair> next();
    /// Puts children of the pair that `next` returned last on the stack; the last one is next.
    void push_children(std::span<const WidePair> pairs);
    /// Takes a pair off the stack without looking at it. There is one.
    [[nodiscard]] WidePair pop();

  private:
    struct Waiting {
        WidePair nodes;
        PlaneNormal normal;
    };

    PlanePose pose_;
    std::optional<PlaneBody> a_;
    std::optional<PlaneBody> b_;
    std::vector<Waiting> pairs_;
    PlaneNormal normal_{}; ///< Of the pair that `next` returned last.
};

} // namespace cd
