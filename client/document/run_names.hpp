// Names of scenarios and parts in a report.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/job/prepared_job.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace cd {

/// Names what a run has. Manifest and job must outlive the object.
class RunNames {
  public:
    RunNames(const RunManifest& manifest, const PreparedJob& job)
        : manifest_(manifest), job_(job) {}

    /// Returns a scenario's number with its id: "#17, id left". In a scene it has the step and the
    /// bodies instead, "#17, step 2, truck x wall", and with lines the id of their bundle: "#17,
    /// step 2, truck, az=30 el=-15 tile=2,-1". Reads the scenario's poses in a scene.
    [[nodiscard]] std::string name_of(std::uint64_t scenario) const;

    /// Returns a scenario's name with its time: "#17, id left, t 0.5", of a motion "#17, t 0.5 to
    /// 1".
    [[nodiscard]] std::string label_of(std::uint64_t scenario) const;

    /// Returns a part's name, with its body's name unless the job has two bodies.
    [[nodiscard]] std::string part_name(std::uint32_t body, const std::string& part) const;

  private:
    [[nodiscard]] std::string place_in_scene(std::uint64_t scenario) const;

    const RunManifest& manifest_;
    const PreparedJob& job_;
};

} // namespace cd
