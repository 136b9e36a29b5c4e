// What a report tells of a scene: which pairs of bodies were tested, and when they are in contact.
#pragma once

#include "client/document/html.hpp"
#include "client/job/prepared_job.hpp"
#include "client/scene/body_episodes.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"
#include "common/job/result/record_file.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// The coverage and the worst episodes of a run of a scene.
class SceneSections {
  public:
    /// Reads all results of a run. Errors: those of the records; Interrupted.
    [[nodiscard]] static Result<SceneSections>
    read(const RecordFile& records, const PreparedJob& job, const StopCheck& stop);

    /// Counts the pairs of bodies, and lists the worst episodes. Of lines through a scene, only
    /// the pairs of a body and a bundle are counted.
    [[nodiscard]] Html section() const;

  private:
    explicit SceneSections(const PreparedJob& job);

    void add(const std::vector<BodyEpisode>& episodes);
    /// Keeps only the worst episodes, worst first.
    void keep_worst();
    [[nodiscard]] Html table() const;

    std::vector<std::string> names_; ///< Of each body.
    std::shared_ptr<const StepIndex> steps_;
    bool has_lines_ = false;
    std::uint64_t failed_ = 0; ///< Scenarios without an answer.
    std::uint64_t count_ = 0;  ///< Number of all episodes.
    std::vector<BodyEpisode> worst_;
};

} // namespace cd
