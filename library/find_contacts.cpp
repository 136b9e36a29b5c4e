#include "client/job/prepared_job.hpp"
#include "client/local/local_run.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"
#include "library/borrowed_poses.hpp"
#include "library/call_clock.hpp"
#include "library/errors.hpp"
#include "library/mesh_state.hpp"
#include "library/result_arrays.hpp"

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

/// Runs the first scenarios on this thread, for as long as `alone_for`. Returns their merger.
cd::ResultMerger
run_alone(PairSearch& search, const BorrowedPoses& poses, CallClock& clock, ResultArrays& results) {
    cd::ResultMerger merger(poses.count());
    PairSearch::Use use(search, [&] { return clock.is_stopped(merger.summary()); });
    while (!merger.summary().is_complete() && clock.elapsed() < alone_for) {
        const cd::ScenarioRun run = use.run(value_of(poses.at(merger.summary().merged())));
        if (run.is_stopped) {
            check(cd::interrupted());
        }
        static_cast<void>(merger.add(run.result));
        results.add(run.result, run.found);
    }
    return merger;
}

/// Runs the scenarios that `done` lacks on threads. Returns the digest of all.
std::optional<cd::Sha256> run_rest(const PairSearch& search,
                                   BorrowedPoses& poses,
                                   const Query& asked,
                                   cd::ResultMerger done,
                                   CallClock& clock,
                                   ResultArrays& results) {
    cd::ThreadPool pool(asked.threads);
    const cd::RunObserver observer{[&](const cd::DoneBlock& block) {
                                       return block.for_each(
                                           [&](const cd::DoneScenario& each) -> cd::Status {
                                               results.add(each.result, each.found);
                                               return cd::Done{};
                                           });
                                   },
                                   [&](const cd::Summary& summary, double) { clock.tell(summary); },
                                   [&] { return clock.was_stopped(); }};
    cd::LocalRunOptions options;
    options.done = std::move(done);
    return value_of(cd::run_locally(
                        search.trees(), poses, search.query(), pool, observer, std::move(options)))
        .digest;
}

Results find(const Mesh& a,
             const Mesh& b,
             const Poses& poses,
             const Query& asked,
             const std::function<void(Results&&)>& each_window) {
    CallClock clock(asked.progress);
    BorrowedPoses rows(poses);
    const bool wants_points = rows.count() >= cd::limits::run_points_scenarios_min;
    const std::shared_ptr<PairSearch> search =
        search_of(a, b, engine_query(asked, mesh_of(a), mesh_of(b)), wants_points, asked.threads);
    ResultArrays results(each_window, {"a", "b"});
    if (asked.maps) {
        results.count_maps();
    }
    clock.restart();
    cd::ResultMerger merger = run_alone(*search, rows, clock, results);
    const std::optional<cd::Sha256> digest =
        merger.summary().is_complete()
            ? merger.digest()
            : run_rest(*search, rows, asked, std::move(merger), clock, results);
    return results.finish(digest, {a.triangle_count(), b.triangle_count()});
}

} // namespace

Results find_contacts(const Mesh& a, const Mesh& b, const Poses& poses, const Query& query) {
    return find(a, b, poses, query, {});
}

Results find_contacts(const Mesh& a,
                      const Mesh& b,
                      const Poses& poses,
                      const Query& query,
                      const std::function<void(Results&&)>& each_window) {
    return find(a, b, poses, query, each_window);
}

} // namespace cdcluster
