// What lines tell of the parts of a body: how much of them is seen, and how thick they are.
#pragma once

#include "client/export/shots/bundle_passages.hpp"
#include "client/export/shots/shot_job.hpp"
#include "client/report/report.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Sums the passages of all lines by part.
class ShotSums {
  public:
    /// `unit` is the job's, for display.
    ShotSums(std::shared_ptr<const ShotJob> job, std::string unit);

    /// Adds the next result of Question::Shots at level pairs, in submitted order. Errors: as
    /// `PassageGatherer::add`.
    [[nodiscard]] Status add(const ScenarioResult& result);
    /// Adds what is left of the last bundle.
    void finish();
    /// Returns the parts that lines cross, those that most lines cross first. In a scene the name
    /// of a part follows that of its body.
    [[nodiscard]] std::vector<ShotPart> parts() const;

  private:
    struct Sum {
        std::uint64_t lines = 0;
        std::uint64_t crossings = 0;
        std::uint64_t passages = 0; ///< With a thickness.
        double thickness = 0;
        double thickest = 0;
    };

    void add(const BundlePassages& bundle);

    std::shared_ptr<const ShotJob> job_;
    PassageGatherer gatherer_;
    std::string unit_;
    /// Of a cell, over the number of directions and steps; 0 without a grid.
    double area_of_line_ = 0;
    std::vector<std::vector<Sum>> sums_; ///< By body and part.
};

} // namespace cd
