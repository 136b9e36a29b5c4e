// Where the last contacts were, for poses that follow each other closely.
#pragma once

#include "common/geometry/pose.hpp"
#include "common/pair/triangle_pair.hpp"
#include "common/tree/wide/pair_buckets.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cd {

/// The pairs of nodes in which the last descents found contacts, and whether they are worth a look:
/// neighbouring poses mostly touch in the same places.
class LastContacts {
  public:
    static constexpr std::size_t places_max = 2;
    static constexpr int lately_max = 8;

    /// Takes the next pose and trees. The pose is near if no point of B moves by more than 0.4 of
    /// B's size, and the trees are those of the last call. Else forgets all places. A tree is
    /// known by the address and number of its nodes. A later tree may have both, too; then places
    /// are still within bounds, and cost time but no answer.
    void move_to(const RelativePose& b_to_a, const WideView& a, const WideView& b);
    [[nodiscard]] bool is_near() const { return is_near_; }

    /// Notes a contact, as slots of the trees that `move_to` took last, if the pose is near: single
    /// poses and searches that change trees need no places.
    void add(const WideView& a, const WideView& b, const Candidate& contact);

    /// Notes whether the bodies touch in the pose that `move_to` took last.
    void note_answer(bool touches);
    /// Returns whether a contact is likely: a near pose mostly has the last answer, another one
    /// that of most poses lately. True at first.
    [[nodiscard]] bool expects_contact() const;

    /// Returns pairs of nodes directly above leaves, that of the last contact first.
    [[nodiscard]] std::span<const WidePair> places() const { return {places_.data(), count_}; }

  private:
    /// The parents of a tree's leaves, found when first asked for.
    class Parents {
      public:
        [[nodiscard]] std::uint32_t of(const WideView& tree, std::uint32_t block);

      private:
        std::span<const WideNode> nodes_; ///< The tree.
        std::vector<std::uint32_t> of_block_;
    };

    RelativePose pose_{};
    std::span<const WideNode> nodes_a_; ///< Only compared, since the tree may be gone.
    std::span<const WideNode> nodes_b_;
    bool is_near_ = false;
    bool has_touched_ = true; ///< The last answer.
    int lately_ = lately_max; ///< Rises with each contact, and falls with each other answer.
    Parents parents_a_;
    Parents parents_b_;
    std::array<WidePair, places_max> places_{};
    std::size_t count_ = 0;
};

} // namespace cd
