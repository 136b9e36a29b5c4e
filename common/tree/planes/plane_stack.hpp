// The pairs of nodes of a descent that planes may part.
#pragma once

#include "common/tree/neighbours/kept_normals.hpp"
#include "common/tree/planes/plane_kernel.hpp"
#include "common/tree/wide/pair_buckets.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// A stack of pairs of nodes, each with the normal that its parents' plane had, or its own plane
/// under the last pose, if that is near. Keeps its memory.
class PlaneStack {
  public:
    /// Forgets all pairs and takes other trees, which have support points and outlive the calls.
    /// Keeps normals if the pose is near the last one and the trees are the same.
    void reset(const PlanePose& pose, const WideView& a, const WideView& b, bool is_near);
    /// Changes the reach of the pose (PlanePose::reach) to a smaller one.
    void set_reach(float reach) { pose_.reach = reach; }
    void push_roots();
    void clear() { pairs_.clear(); }
    [[nodiscard]] std::size_t size() const { return pairs_.size(); }
    /// Returns a normal that parts the whole bodies, ignoring the reach, or nearly does.
    [[nodiscard]] PlaneNormal root_normal() const;

    /// Takes pairs off the stack until one cannot be parted; returns it, or nothing if no pair is
    /// left.
    [[nodiscard]] std::optional<WidePair> next();
    /// Puts children of the pair that `next` returned last on the stack. Unless the pose is near
    /// the last one, leaves out those that planes part at once, and the pair with the least slack
    /// along the parents' normal is next: it is the most likely to be in contact. Near the last
    /// pose, what is known of a pair is worth more than what its siblings share, and the last pair
    /// is next.
    void push_children(std::span<const WidePair> pairs);
    /// Takes a pair off the stack without looking at it. There is one.
    [[nodiscard]] WidePair pop();
    /// Tests whether a plane parts a pair that is not on the stack; tries planes of `normal` first.
    [[nodiscard]] bool parts(WidePair nodes, const PlaneNormal& normal);

  private:
    struct Waiting {
        WidePair nodes;
        PlaneNormal normal;
        bool is_tested; ///< No plane parts it.
    };

    [[nodiscard]] bool is_apart(Waiting& pair);

    PlanePose pose_;
    std::optional<PlaneBody> a_;
    std::optional<PlaneBody> b_;
    std::vector<Waiting> pairs_;
    PlaneNormal normal_{};            ///< Of the pair that `next` returned last.
    std::optional<KeptNormals> kept_; ///< Of poses near each other; made for the first of them.
    bool uses_kept_ = false;
    std::vector<PlaneTrial> trials_;
};

} // namespace cd
