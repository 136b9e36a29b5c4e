// A job's lines, and the bodies that they may hit, as exports of hits need them.
#pragma once

#include "client/bundle/shot_plan.hpp"
#include "client/export/result_writer.hpp"
#include "client/export/shots/passages.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/scene/step_index.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cd {

class ShotJob {
  public:
    /// The context is of a job with lines, which are its last body. Takes near-linear time in the
    /// number of triangles.
    explicit ShotJob(const ExportContext& context);

    /// Number of the bodies that lines may hit: all but the lines.
    [[nodiscard]] std::size_t bodies() const { return targets_.size(); }
    /// Returns the name of a body; empty in a job of two bodies.
    [[nodiscard]] const std::string& name(std::size_t body) const { return targets_[body].name; }
    [[nodiscard]] const Mesh& mesh(std::size_t body) const { return *targets_[body].mesh; }
    [[nodiscard]] const PassageFinder& finder(std::size_t body) const {
        return *targets_[body].finder;
    }
    [[nodiscard]] const Mesh& lines() const { return *lines_; }
    [[nodiscard]] const ShotViews& views() const { return views_; }
    /// Returns the steps of a scene; null for a job of two bodies.
    [[nodiscard]] const std::shared_ptr<const StepIndex>& steps() const { return steps_; }
    /// Returns the poses of a scene's scenarios; null for a job of two bodies, whose body A stands
    /// at the identity, and where they are not at hand.
    [[nodiscard]] const std::shared_ptr<PoseSource>& poses() const { return poses_; }
    /// False for lines of a file through a scene whose poses are not at hand: which of them end
    /// inside a body is not known then.
    [[nodiscard]] bool knows_ends() const;
    /// Whether of each line only the first crossing counts, of all bodies together.
    [[nodiscard]] bool takes_first() const { return takes_first_; }

  private:
    struct Target {
        std::string name;
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const PassageFinder> finder; ///< Bodies of one mesh share it.
    };

    std::vector<Target> targets_;
    std::shared_ptr<const Mesh> lines_;
    ShotViews views_;
    std::shared_ptr<const StepIndex> steps_;
    std::shared_ptr<PoseSource> poses_;
    bool takes_first_;
};

} // namespace cd
