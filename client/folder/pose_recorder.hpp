// Poses that are kept while a run reads them.
#pragma once

#include "common/core/result.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/scenario_file.hpp"

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cd {

/// Reads from another source, and writes each scenario that goes on from those written before.
class PoseRecorder final : public PoseSource {
  public:
    PoseRecorder(std::unique_ptr<PoseSource> source, ScenarioWriter writer)
        : source_(std::move(source)), writer_(std::move(writer)) {}

    [[nodiscard]] std::uint64_t count() const override { return source_->count(); }
    [[nodiscard]] const Grid* grid() const override { return source_->grid(); }
    /// Errors: also Io of the file.
    [[nodiscard]] Result<std::vector<Scenario>> read(std::uint64_t first,
                                                     std::uint64_t count) override;

    /// Reads and writes what nobody has read, and completes the file. Errors: those of `read`.
    [[nodiscard]] Status finish();

  private:
    std::unique_ptr<PoseSource> source_;
    std::mutex mutex_;
    ScenarioWriter writer_;
};

} // namespace cd
