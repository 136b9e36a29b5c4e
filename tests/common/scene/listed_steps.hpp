// The poses of a scene's steps, in memory.
#pragma once

#include "common/scene/step_poses.hpp"

#include <utility>
#include <vector>

namespace cd::tests {

class ListedSteps final : public StepPoses {
  public:
    explicit ListedSteps(std::vector<PosesOfStep> steps, std::vector<double> times = {})
        : steps_(std::move(steps)), times_(std::move(times)) {}

    std::uint64_t steps() const override { return steps_.size(); }
    Result<PosesOfStep> read(std::uint64_t step) override { return steps_[step]; }
    std::vector<double> times() const override { return times_; }

  private:
    std::vector<PosesOfStep> steps_;
    std::vector<double> times_;
};

} // namespace cd::tests
