// Poses in the caller's memory as scenarios.
#pragma once

#include "client/poses/pose_rows.hpp"
#include "common/job/poses/pose_source.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cdcluster {

/// Reads scenarios from borrowed numbers, of which the first has the index `first`. Throws BadInput
/// naming the row of the first bad pose.
class BorrowedPoses final : public cd::PoseSource {
  public:
    explicit BorrowedPoses(const Poses& poses, std::uint64_t first = 0);

    [[nodiscard]] std::uint64_t count() const override { return poses_.numbers.size() / size_; }
    [[nodiscard]] cd::Result<std::vector<cd::Scenario>> read(std::uint64_t first,
                                                             std::uint64_t count) override;
    [[nodiscard]] std::string place_of(std::uint64_t scenario) const override;

    /// Returns the scenario of a row, which exists. Errors: BadInput naming the row.
    [[nodiscard]] cd::Result<cd::Scenario> at(std::uint64_t row) const;

  private:
    Poses poses_;
    std::uint64_t first_; ///< Index of the scenario of row 0.
    cd::PoseLayout layout_;
    std::size_t size_; ///< Numbers of a pose.
};

} // namespace cdcluster
