// Names of scenarios and parts in a report.
#pragma once

#include "client/document/html.hpp"
#include "client/folder/run_manifest.hpp"
#include "common/core/words.hpp"
#include "common/job/poses/pose_labels.hpp"

#include <cstdint>
#include <string>

namespace cd {

/// Names what a run has. Manifest and labels must outlive the object.
class RunNames {
  public:
    RunNames(const RunManifest& manifest, const PoseLabels& labels)
        : manifest_(manifest), labels_(labels) {}

    /// Returns a scenario's number with its id: "#17, id left".
    [[nodiscard]] std::string name_of(std::uint64_t scenario) const {
        std::string text = "#" + std::to_string(scenario);
        if (scenario < labels_.integers.size()) {
            text += ", id " + std::to_string(labels_.integers[scenario]);
        } else if (scenario < labels_.texts.size()) {
            text += ", id " + short_name(labels_.texts[scenario]);
        }
        return text;
    }

    /// Returns a scenario's name with its time: "#17, id left, t 0.5", of a motion "#17, t 0.5 to
    /// 1".
    [[nodiscard]] std::string label_of(std::uint64_t scenario) const {
        std::string text = name_of(scenario);
        if (scenario < labels_.times.size()) {
            text += ", t " + exact_text(labels_.times[scenario]);
        }
        if (scenario < labels_.end_times.size()) {
            text += " to " + exact_text(labels_.end_times[scenario]);
        }
        return text;
    }

    /// Returns a part's name, with its body's name unless the job has two bodies.
    [[nodiscard]] std::string part_name(std::uint32_t body, const std::string& part) const {
        return manifest_.bodies.size() == 2
                   ? short_name(part)
                   : short_name(manifest_.bodies[body].name) + "/" + short_name(part);
    }

  private:
    const RunManifest& manifest_;
    const PoseLabels& labels_;
};

} // namespace cd
