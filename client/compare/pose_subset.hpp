// Some scenarios of a job as a job of their own.
#pragma once

#include "common/core/result.hpp"
#include "common/job/poses/pose_source.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace cd {

/// The scenarios of another source with given indices, numbered from 0.
class PoseSubset final : public PoseSource {
  public:
    /// `source` outlives the object. `indices` ascend.
    PoseSubset(PoseSource& source, std::vector<std::uint64_t> indices)
        : source_(source), indices_(std::move(indices)) {}

    [[nodiscard]] std::uint64_t count() const override { return indices_.size(); }
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Returns the index in the source of scenario `number`, which exists.
    [[nodiscard]] std::uint64_t index_of(std::uint64_t number) const { return indices_[number]; }

  private:
    PoseSource& source_;
    std::vector<std::uint64_t> indices_;
};

} // namespace cd
