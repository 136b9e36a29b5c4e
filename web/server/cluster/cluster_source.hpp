// The page's data from a cluster.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "proto/channel/asio.hpp"
#include "web/server/cluster/cluster_jobs.hpp"
#include "web/server/cluster/cluster_reader.hpp"
#include "web/server/page_source.hpp"
#include "web/server/scenario_runs.hpp"

#include <chrono>
#include <deque>
#include <memory>
#include <string>

namespace cd {

/// What a `ClusterSource` uses. Everything referenced outlives it, and the reader outlives the
/// functions on the pool `reading`.
struct ClusterSourceParts {
    asio::any_io_executor executor; ///< Of the page's server.
    ClusterReader& reader;
    Pool& reading; ///< For the reader's blocking calls.
    Pool& running; ///< For runs of scenarios.
    /// A run of a scenario ends after this time.
    std::chrono::seconds run_max;
    StopCheck stop = {}; ///< Ends the run of a scenario.
};

/// Samples the cluster's activity each second between `start` and `close`.
class ClusterSource final : public PageSource {
  public:
    ClusterSource(ClusterSourceParts parts, PageOrigin origin);

    void start() { sample(); }
    void close();

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
    void sample();
    void add_sample(const ClusterStatus& now);
    /// Calls `take` with what `work` returns on the pool `reading`.
    template <class T, class Work>
    void read(Take<T> take, Work work);
    /// Calls `then` with the job, or `take` with an error.
    template <class T, class Then>
    void with_job(const std::string& id, Take<T> take, Then then);
    /// As `with_job`; `work` gets the reader of the job's records and runs on the pool `reading`.
    template <class T, class Work>
    void with_records(const std::string& id, Take<T> take, Work work);
    void run(const ScenarioRuns::Key& key,
             const Result<ScenarioInputs>& inputs,
             Take<std::shared_ptr<const ScenarioView>> take);

    ClusterSourceParts parts_;
    PageOrigin origin_;
    ScenarioRuns runs_;
    asio::steady_timer timer_;
    std::deque<HistorySample> samples_;
    ClusterStatus last_; ///< The status at the last sample.
    bool is_closed_ = false;
    std::shared_ptr<const void> alive_ =
        std::make_shared<int>(0); ///< Lives as long as this object.
};

} // namespace cd
