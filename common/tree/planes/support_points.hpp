// Makes and owns the support points of a wide tree.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "common/tree/planes/support_view.hpp"
#include "common/tree/wide/wide_node.hpp"

#include <cstdint>
#include <vector>

namespace cd {

/// A node with at most this many vertices in its blocks has all of them as its points.
inline constexpr std::uint32_t support_vertices_max = 64;

/// The most chosen points of a node.
inline constexpr std::uint32_t support_points_max = 80;

/// Points of a wide tree. Small nodes use the vertices of their blocks. A large node chooses among
/// its children's points, from the leaves up, and its eps is the children's largest one plus its
/// own. Equal for any number of threads.
class SupportPoints {
  public:
    /// Makes the points of a tree that has nodes. Without a pool the caller's thread does all work.
    explicit SupportPoints(const WideView& tree, ThreadPool* pool = nullptr);

    /// Valid while this object lives.
    [[nodiscard]] SupportView view() const { return {sets_, columns_, center_, radius_, id_}; }
    [[nodiscard]] std::uint64_t memory_bytes() const {
        return sets_.size() * sizeof(SupportSet) + columns_.size() * sizeof(float);
    }

  private:
    std::vector<SupportSet> sets_;
    std::vector<float> columns_;
    std::array<float, 3> center_{};
    double radius_ = 0;
    std::uint64_t id_ = next_support_id();
};

} // namespace cd
