// The paper's experiments (section 7), each a series of simulations that varies one thing.
#pragma once

#include "bench/accuracy/csv.hpp"
#include "bench/cluster/model/simulation.hpp"
#include "bench/cluster/model/strategies.hpp"
#include "bench/cluster/model/workload.hpp"
#include "bench/cluster/trace/trace.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace cd::bench {

/// One point of an experiment.
struct Point {
    std::string experiment;  ///< scenarios, depth, q, cores, paper depth, fit.
    double x = 0;            ///< Varied quantity.
    std::uint64_t count = 0; ///< Number of scenarios; 0: all.
    std::uint32_t depth = 0;
    std::uint32_t q = 20;
    std::uint32_t fast_cores = 20;
    std::uint32_t slow_cores = 8;
};

/// Location of a job, and the costs of its steps.
struct Setting {
    std::string name;
    Costs costs = Costs::Paper;
    double analysis_seconds = 0;  ///< Time of each analysis; 0: as the costs say.
    SimulationOptions options;    ///< `options_for` sets strategy, q, seed and cores.
    bool may_claim = true;        ///< False: no strategy claims.
    bool is_client_first = false; ///< The paper's strategies have their client-first form.
    std::uint64_t seeds_max = 3;

    /// The compared strategies.
    [[nodiscard]] std::vector<ComparedStrategy> strategies() const;
    /// The paper's strategy in the form that the setting takes as the paper's.
    [[nodiscard]] const char* best() const {
        return is_client_first ? "best-match-pull" : "best-match";
    }
    /// The strategy by whose time the pipe is fitted.
    [[nodiscard]] ComparedStrategy lowest() const {
        return is_client_first ? client_first_strategies[2]
                               : ComparedStrategy{"lowest", true, false};
    }
    [[nodiscard]] SimulationOptions
    options_for(const ComparedStrategy& strategy, const Point& point, std::uint64_t seed) const;
};

/// Returns a setting without fitted constants: the paper's master and clients (one analysis at a
/// time, results at the end of a task) on SimGrid's network alone.
[[nodiscard]] Setting paper_setting();
/// Returns the paper's setting with a pipe.
[[nodiscard]] Setting fitted_setting(double pipe_bytes_per_second);
/// Returns the fitted setting with a second fitted number, 3 ms for each analysis, and the paper's
/// strategies in the client-first form of its section 5.1.
[[nodiscard]] Setting client_first_setting(double pipe_bytes_per_second);
/// Returns measured costs with the product's behaviour: one worker per computer, two tasks at a
/// worker, analysis on the other cores of the master's computer, the product's limits. One seed
/// suffices: jobs are so long compared with their start that the order does not matter.
[[nodiscard]] Setting measured_setting();

struct Scene {
    const Trace* trace = nullptr;
    const PaperTable* table = nullptr;
    std::uint32_t paper_depth = 12; ///< Depth at which the paper cut the fixed body.
    std::uint32_t depth = 12;       ///< Depth in experiments that do not vary it.
};

struct ExperimentOptions {
    std::filesystem::path out;
    std::uint64_t seeds = 3;
    bool quick = false; ///< Only the ends and the middle of each series, with one seed.
    std::chrono::seconds limit{600}; ///< Limit for one simulation.

    [[nodiscard]] std::uint64_t seeds_of(const Setting& setting) const {
        return quick ? 1 : std::min(seeds, setting.seeds_max);
    }
};

/// Runs points and writes a row for each into runs.csv. A simulation that does not end causes a
/// line on stderr and no row.
class Experiments {
  public:
    explicit Experiments(const ExperimentOptions& options);

    void run(const Setting& setting, const Scene& scene, const Point& point);

    /// Speed-up against the number of scenarios (Figure 10): the rows of the paper's table.
    void vary_scenarios(const Setting& setting, const Scene& scene);
    /// Measures jobs of multiples of the trace's scenarios.
    void vary_rounds(const Setting& setting,
                     const Scene& scene,
                     const std::vector<std::uint64_t>& rounds);
    /// Runs all scenarios at the paper's depth, if it was recorded.
    void at_paper_depth(const Setting& setting, const Scene& scene);
    /// Varies the depth of A's cut (Figure 11). Returns the depth at which the setting's best
    /// strategy is fastest.
    std::uint32_t vary_depth(const Setting& setting, const Scene& scene, std::uint64_t count = 0);
    /// Varies q (Figure 12).
    void vary_q(const Setting& setting, const Scene& scene, std::uint64_t count = 0);
    /// Varies the cluster (Figure 13, Table 4).
    void vary_cores(const Setting& setting, const Scene& scene, std::uint64_t count = 0);

    /// Returns the pipe rate at which the setting's `lowest` takes so many seconds for all
    /// scenarios, by a line through the times of all seeds at rates around it (`rate_on_line`).
    /// Returns nothing if no rate does.
    std::optional<double>
    fit_pipe(Setting (*setting_of)(double), const Scene& scene, double seconds);

  private:
    std::optional<Outcome> simulate_one(const Setting& setting,
                                        const Scene& scene,
                                        const Workload& workload,
                                        const ComparedStrategy& strategy,
                                        const Point& point,
                                        std::uint64_t seed);
    /// Returns the coordinator's time per scenario, once measured.
    double dispatch_seconds(const Scene& scene,
                            const Workload& workload,
                            const Point& point,
                            const SimulationOptions& uncharged);
    /// Returns the mean seconds of `lowest`. Returns nothing if no simulation ends.
    [[nodiscard]] std::optional<double> mean_lowest(const Setting& setting, const Scene& scene);
    template <class T>
    [[nodiscard]] std::vector<T> series(std::vector<T> all) const;

    ExperimentOptions options_;
    CsvFile csv_;
    /// Keyed by scene, strategy, peers, and depth.
    std::map<std::tuple<std::string, std::string, bool, std::uint32_t>, double> dispatch_seconds_;
    double best_seconds_ = 0; ///< The setting's best strategy: last point, mean of the seeds.
};

} // namespace cd::bench
