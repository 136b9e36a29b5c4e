// The page's data from a run on this machine.
#pragma once

#include "client/view/viewed_run.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "proto/channel/asio.hpp"
#include "web/server/page_source.hpp"
#include "web/server/scenario_runs.hpp"

#include <functional>
#include <memory>
#include <string>

namespace cd {

/// Reads on a thread of its own, and runs scenarios on another. There is one job, and no cluster.
class FolderSource final : public PageSource {
  public:
    /// The executor's context outlives this object. `stop` ends the run of a scenario.
    FolderSource(asio::any_io_executor executor, std::unique_ptr<ViewedRun> run, StopCheck stop);
    ~FolderSource() override;

    [[nodiscard]] const PageOrigin& origin() const override { return origin_; }
    void cluster(Take<ClusterView> take) override;
    void history(Take<std::vector<HistorySample>> take) override;
    void jobs(Take<std::vector<JobRow>> take) override;
    void job(const std::string& id, Take<JobView> take) override;
    void progress(const std::string& id, Take<JobRow> take) override;
    void classes(const std::string& id,
                 const ScenarioChoice& choice,
                 Take<std::vector<std::uint8_t>> take) override;
    void counts(const std::string& id,
                const ScenarioChoice& choice,
                Take<std::vector<std::uint32_t>> take) override;
    void distances(const std::string& id,
                   const ScenarioChoice& choice,
                   Take<std::vector<double>> take) override;
    void poses(const std::string& id, const ScenarioChoice& choice, Take<PoseRows> take) override;
    void keys(const std::string& id,
              const ScenarioChoice& choice,
              Take<std::vector<MotionKeys>> take) override;
    void bodies(const std::string& id,
                const ScenarioChoice& choice,
                Take<std::vector<ScenePlace>> take) override;
    void steps(const std::string& id,
               const ScenarioChoice& choice,
               Take<std::vector<StepRow>> take) override;
    void map(const std::string& id,
             std::uint64_t body,
             Take<std::vector<TriangleContacts>> take) override;
    void parts(const std::string& id,
               std::uint64_t body,
               Take<std::shared_ptr<const NamedParts>> take) override;
    void
    closed_parts(const std::string& id, std::uint64_t body, Take<std::vector<bool>> take) override;
    void scenario(const std::string& id,
                  std::uint64_t number,
                  Take<std::shared_ptr<const ScenarioView>> take) override;
    void next(const std::string& id, const NextContact& wanted, Take<NextFound> take) override;
    void mesh(const Sha256& mesh, Take<std::shared_ptr<HttpBody>> take) override;

  private:
    /// Calls `take` with what `read` returns on the reading thread; NotFound for another job.
    template <class T, class Read>
    void answer(const std::string& id, Take<T> take, Read read);
    [[nodiscard]] Result<std::shared_ptr<HttpBody>> mesh_body(const Sha256& mesh);

    asio::any_io_executor executor_;
    std::unique_ptr<ViewedRun> run_;
    PageOrigin origin_;
    std::shared_ptr<std::atomic<bool>> is_closed_ = std::make_shared<std::atomic<bool>>(false);
    StopCheck stop_;
    ThreadPool reader_{1};
    ThreadPool runner_{1};
    ScenarioRuns runs_;
};

} // namespace cd
