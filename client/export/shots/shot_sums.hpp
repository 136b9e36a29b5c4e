// What lines tell of the parts of a body: how much of them is seen, and how thick they are.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/shots/passages.hpp"
#include "client/report/report.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Sums the passages of all lines by part.
class ShotSums {
  public:
    /// `unit` is the job's, for display.
    ShotSums(std::shared_ptr<const PassageFinder> finder, const ShotViews& views, std::string unit);

    /// Adds a result of Question::Shots at level pairs.
    void add(const ScenarioResult& result);
    /// Returns the parts that lines cross, those that most lines cross first.
    [[nodiscard]] std::vector<ShotPart> parts() const;

  private:
    struct Sum {
        std::uint64_t lines = 0;
        std::uint64_t crossings = 0;
        std::uint64_t passages = 0; ///< With a thickness.
        double thickness = 0;
        double thickest = 0;
    };

    std::shared_ptr<const PassageFinder> finder_;
    std::string unit_;
    double area_of_line_ = 0; ///< Of a cell, over the number of directions; 0 without a grid.
    std::vector<Sum> sums_;
};

} // namespace cd
