#include "library/pose_sweep.hpp"

#include "client/job/prepared_job.hpp"
#include "client/local/local_run.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "common/geometry/part_runs.hpp"
#include "library/borrowed_poses.hpp"
#include "library/call_clock.hpp"
#include "library/errors.hpp"
#include "library/mesh_state.hpp"
#include "library/result_arrays.hpp"

#include <span>
#include <utility>

namespace cdcluster {

namespace {

/// A call works alone for this long before it starts threads.
constexpr auto alone_for = std::chrono::milliseconds(1);

/// Returns the engine's query. Throws BadInput for what does not go together.
cd::Query engine_query(const Query& asked, const cd::Mesh& a, const cd::Mesh& b) {
    cd::Query query;
    const auto level = static_cast<std::size_t>(asked.level);
    if (level >= cd::asked_levels.size()) {
        throw Error(ErrorCode::BadInput, "level is none of Level");
    }
    static_cast<void>(cd::set_asked_level(cd::asked_levels.at(level), query));
    query.limit_pairs = asked.limit_pairs;
    query.maps = asked.maps;
    query.clearance = asked.clearance;
    query.up_to = asked.up_to;
    if (const auto conflict = cd::conflict_in(query)) {
        throw Error(ErrorCode::BadInput,
                    std::string(conflict->key) + ": " + std::string(conflict->reason));
    }
    if (const char* const problem = cd::query_problem(query)) {
        throw Error(ErrorCode::BadInput, problem);
    }
    if (!asked.ignore.empty()) {
        cd::JobSpec spec;
        for (const IgnoreRule& rule : asked.ignore) {
            spec.ignore.push_back({rule.a, rule.b});
        }
        query.ignored = value_of(cd::resolve_ignored(spec, a, b));
    }
    return query;
}

} // namespace

/// The poses of one call.
class PoseSweep::Part {
  public:
    Part(PoseSweep& sweep,
         const Poses& poses,
         const std::function<void(Results&&)>& each_window,
         KeptAnswers* kept)
        : sweep_(sweep),
          clock_(sweep.asked_.progress),
          poses_(poses, sweep.first_),
          results_(each_window, {"a", "b"}, sweep.first_),
          kept_(kept) {
        if (sweep.query_.maps) {
            results_.count_maps(cd::body_part_runs(mesh_of(sweep.a_), mesh_of(sweep.b_)));
        }
    }

    /// Answers the poses. Returns their number.
    std::uint64_t run() {
        const bool wants_points = poses_.count() >= cd::limits::run_points_scenarios_min;
        cd::Summary none;
        none.total = poses_.count();
        const std::shared_ptr<PairSearch> search = search_of(
            sweep_.a_, sweep_.b_, sweep_.query_, wants_points, sweep_.asked_.threads, [&] {
                return clock_.is_stopped(none);
            });
        clock_.restart();
        cd::ResultMerger merger = run_alone(*search);
        if (!merger.summary().is_complete()) {
            run_rest(*search, std::move(merger));
        }
        if (kept_ != nullptr) {
            kept_->seconds += std::chrono::duration<double>(clock_.elapsed()).count();
        }
        return poses_.count();
    }

    Results finish(const std::optional<cd::Sha256>& digest) {
        std::optional<cd::ContactMap> map = results_.take_map();
        if (kept_ != nullptr) {
            kept_->map = map;
        }
        return results_.finish(
            digest, {sweep_.a_.triangle_count(), sweep_.b_.triangle_count()}, std::move(map));
    }

  private:
    /// Runs the first scenarios on this thread, for as long as `alone_for`. Returns their merger.
    cd::ResultMerger run_alone(PairSearch& search) {
        cd::ResultMerger merger(poses_.count());
        PairSearch::Use use(search, [&] { return clock_.is_stopped(merger.summary()); });
        while (!merger.summary().is_complete() && clock_.elapsed() < alone_for) {
            const cd::ScenarioRun run = use.run(value_of(poses_.at(merger.summary().merged())));
            if (run.is_stopped) {
                check(cd::interrupted());
            }
            cd::DoneBlock block;
            block.add(run.result);
            keep(block);
            if (kept_ != nullptr) {
                kept_->statistics += {run.statistics, run.inside};
            }
            static_cast<void>(
                merger.add(merger.summary().merged(), block.facts()[0], block.digests()[0]));
            results_.add(run.result, run.found);
        }
        return merger;
    }

    /// Runs the scenarios that `done` lacks on threads.
    void run_rest(const PairSearch& search, cd::ResultMerger done) {
        cd::ThreadPool pool(sweep_.asked_.threads);
        const cd::RunObserver observer{
            [&](const cd::DoneBlock& block) { return take(block); },
            [&](const cd::Summary& summary, double) { clock_.tell(summary); },
            [&] { return clock_.was_stopped(); }};
        cd::LocalRunOptions options;
        options.done = std::move(done);
        options.first_index = sweep_.first_;
        const cd::RunOutcome outcome = value_of(cd::run_locally(
            search.trees(), poses_, search.query(), pool, observer, std::move(options)));
        if (kept_ != nullptr) {
            kept_->threads = pool.size();
            kept_->statistics += outcome.statistics;
        }
    }

    void keep(const cd::DoneBlock& block) {
        sweep_.digest_.update(std::as_bytes(block.digests()));
        if (kept_ != nullptr) {
            const auto records = block.records();
            kept_->records.insert(kept_->records.end(), records.begin(), records.end());
        }
    }

    cd::Status take(const cd::DoneBlock& block) {
        keep(block);
        return block.for_each([&](const cd::DoneScenario& each) -> cd::Status {
            results_.add(each.result, each.found);
            return cd::Done{};
        });
    }

    PoseSweep& sweep_;
    CallClock clock_;
    BorrowedPoses poses_;
    ResultArrays results_;
    KeptAnswers* kept_;
};

PoseSweep::PoseSweep(Mesh a, Mesh b, Query query)
    : a_(std::move(a)),
      b_(std::move(b)),
      asked_(std::move(query)),
      query_(engine_query(asked_, mesh_of(a_), mesh_of(b_))) {}

Results PoseSweep::next(const Poses& poses,
                        bool last,
                        const std::function<void(Results&&)>& each_window,
                        KeptAnswers* kept) {
    Part part(*this, poses, each_window, kept);
    first_ += part.run();
    return part.finish(last ? std::optional(digest_.finish()) : std::nullopt);
}

Results find_contacts(const Mesh& a, const Mesh& b, const Poses& poses, const Query& query) {
    return PoseSweep(a, b, query).next(poses, true);
}

Results find_contacts(const Mesh& a,
                      const Mesh& b,
                      const Poses& poses,
                      const Query& query,
                      const std::function<void(Results&&)>& each_window) {
    return PoseSweep(a, b, query).next(poses, true, each_window);
}

} // namespace cdcluster
