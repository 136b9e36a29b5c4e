// A search of two meshes that is kept between calls.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "common/job/query.hpp"
#include "common/job/run_scenario.hpp"
#include "common/job/trees_by_body.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace cdcluster {

/// Two meshes' trees with a runner of scenarios and its memory. One call at a time may use it.
class PairSearch {
  public:
    PairSearch(std::shared_ptr<const cd::ObbTree> a,
               std::shared_ptr<const cd::ObbTree> b,
               cd::Query query);

    [[nodiscard]] bool is_of(const cd::Mesh& a, const cd::Mesh& b, const cd::Query& query) const;
    [[nodiscard]] bool has_points() const { return has_points_; }
    [[nodiscard]] const cd::TreesByBody& trees() const { return trees_; }
    [[nodiscard]] const cd::Query& query() const { return query_; }

    /// Runs scenarios of one call, one after the other, on the calling thread.
    class Use {
      public:
        /// Takes the search's memory, or memory of its own while another call has that.
        Use(PairSearch& search, cd::StopCheck stop);
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;
        ~Use();

        [[nodiscard]] cd::ScenarioRun run(const cd::Scenario& scenario);

      private:
        PairSearch& search_;
        std::unique_lock<std::mutex> lock_;
        std::optional<cd::ScenarioRunner> own_runner_; ///< Only without the lock.
        std::optional<cd::ScenarioSession> own_session_;
    };

  private:
    std::shared_ptr<const cd::ObbTree> a_;
    std::shared_ptr<const cd::ObbTree> b_;
    cd::Query query_;
    bool has_points_;
    cd::TreesByBody trees_;
    std::mutex mutex_;   ///< Guards all below.
    cd::StopCheck stop_; ///< Of the call that has the lock.
    cd::ScenarioRunner runner_;
    cd::ScenarioSession session_;
};

} // namespace cdcluster
