// The trees of a job's bodies.
#pragma once

#include "common/job/scenario.hpp"
#include "common/tree/obb_tree.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cd {

/// The tree of each body of a job, by the body's index. Bodies of one mesh share a tree.
using BodyTrees = std::vector<std::shared_ptr<const ObbTree>>;

/// `BodyTrees` without their ownership: the trees outlive this object.
class TreesByBody {
  public:
    TreesByBody(const ObbTree& a, const ObbTree& b) : trees_{&a, &b} {}
    explicit TreesByBody(std::span<const std::shared_ptr<const ObbTree>> trees) {
        for (const auto& tree : trees) {
            trees_.push_back(tree.get());
        }
    }

    [[nodiscard]] std::span<const ObbTree* const> all() const { return trees_; }
    [[nodiscard]] const ObbTree& of(std::uint32_t body) const { return *trees_.at(body); }
    [[nodiscard]] const ObbTree& a_of(const Scenario& scenario) const {
        return of(scenario.body_a);
    }
    [[nodiscard]] const ObbTree& b_of(const Scenario& scenario) const {
        return of(scenario.body_b);
    }

  private:
    std::vector<const ObbTree*> trees_;
};

} // namespace cd
