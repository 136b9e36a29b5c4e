// The interface between the page and the program that has its data.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/part_runs.hpp"
#include "common/job/result/contact_map.hpp"
#include "proto/channel/http/http_body.hpp"
#include "web/server/page_request.hpp"
#include "web/server/page_values.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cd {

/// Takes an answer. A source calls it once, at once or later, on the thread of the page's server.
template <class T>
using Take = std::function<void(Result<T>)>;

/// All calls are made on the thread of the page's server. Errors: NotFound, BadInput, Refused;
/// TooLarge if the source is too busy; Disconnected, Timeout and Io if it has lost its data.
class PageSource {
  public:
    PageSource() = default;
    PageSource(const PageSource&) = delete;
    PageSource& operator=(const PageSource&) = delete;
    virtual ~PageSource() = default;

    [[nodiscard]] virtual const PageOrigin& origin() const = 0;
    virtual void cluster(Take<ClusterView> take) = 0;
    /// A sample each second, the oldest first.
    virtual void history(Take<std::vector<HistorySample>> take) = 0;
    virtual void jobs(Take<std::vector<JobRow>> take) = 0;
    virtual void job(const std::string& id, Take<JobView> take) = 0;
    /// Tells how far a job is. Reads neither its description nor its bodies.
    virtual void progress(const std::string& id, Take<JobRow> take) = 0;
    /// Each scenario's `ScenarioClass`, or `no_class`.
    virtual void classes(const std::string& id,
                         const ScenarioChoice& choice,
                         Take<std::vector<std::uint8_t>> take) = 0;
    /// Each scenario's number of pairs (`pairs_of_class`); 0 if it is unknown, 2^32 - 1 if it is
    /// larger.
    virtual void counts(const std::string& id,
                        const ScenarioChoice& choice,
                        Take<std::vector<std::uint32_t>> take) = 0;
    /// Each scenario's distance; NaN without one.
    virtual void distances(const std::string& id,
                           const ScenarioChoice& choice,
                           Take<std::vector<double>> take) = 0;
    virtual void
    poses(const std::string& id, const ScenarioChoice& choice, Take<PoseRows> take) = 0;
    /// Each motion's poses at its begin and end. Errors: NotFound for a job without motions.
    virtual void keys(const std::string& id,
                      const ScenarioChoice& choice,
                      Take<std::vector<MotionKeys>> take) = 0;
    /// Each scenario's step and bodies. Errors: NotFound for a job that is no scene.
    virtual void bodies(const std::string& id,
                        const ScenarioChoice& choice,
                        Take<std::vector<ScenePlace>> take) = 0;
    /// The chosen steps. Errors: NotFound for a job that is no scene.
    virtual void
    steps(const std::string& id, const ScenarioChoice& choice, Take<std::vector<StepRow>> take) = 0;
    virtual void
    map(const std::string& id, std::uint64_t body, Take<std::vector<TriangleContacts>> take) = 0;
    /// The parts of a body as the job's groups name them. Errors: NotFound for another body.
    virtual void parts(const std::string& id,
                       std::uint64_t body,
                       Take<std::shared_ptr<const NamedParts>> take) = 0;
    /// Whether each of these parts is closed by itself (`closed_parts`). Errors: as `parts`.
    virtual void
    closed_parts(const std::string& id, std::uint64_t body, Take<std::vector<bool>> take) = 0;
    /// Runs the scenario again.
    virtual void scenario(const std::string& id,
                          std::uint64_t number,
                          Take<std::shared_ptr<const ScenarioView>> take) = 0;
    virtual void next(const std::string& id, const NextContact& wanted, Take<NextFound> take) = 0;
    /// The canonical bytes of a mesh.
    virtual void mesh(const Sha256& mesh, Take<std::shared_ptr<HttpBody>> take) = 0;
};

/// The class of a scenario without a result.
inline constexpr std::uint8_t no_class = 255;

} // namespace cd
