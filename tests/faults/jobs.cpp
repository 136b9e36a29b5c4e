#include "tests/faults/jobs.hpp"

#include "common/core/check.hpp"
#include "common/core/limits.hpp"
#include "common/job/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "tests/faults/world.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>

namespace cd::tests {

namespace {

/// Everything is made before the first simulation, outside of any.
struct Known {
    TemporaryFolder folder; ///< Stays empty: the files are in memory.
    ThreadPool pool{1};
    std::unique_ptr<GeometryStore> store;
    std::vector<std::shared_ptr<const CutGeometry>> cuts; ///< Stay in memory with this.
    std::vector<KnownJob> jobs;

    Known() {
        for (const char* name : {"meshes", "trees", "blocks"}) {
            std::filesystem::create_directories(folder / name);
        }
        store = std::move(GeometryStore::open(folder.path(), pool).value());
        const Sha256 sphere = upload(make_sphere(2));
        const Sha256 torus = upload(make_torus(1, 0.4, 12, 8));
        const Sha256 box = upload(make_gridded_box({1, 2, 1}, 3));
        add_grid(torus, sphere);
        add_list(torus, box, 70, Level::Contacts);
        add_list(sphere, box, 330, Level::Any);
        add_list(sphere, sphere, 24, Level::Count);
        add_list(torus, sphere, 200, Level::Count, true);
    }

    Sha256 upload(const Mesh& mesh) {
        const Bytes bytes = mesh.canonical_bytes();
        auto begun = std::move(store->begin_upload(mesh.hash(), "mesh", bytes.size()).value());
        CD_CHECK(begun->append(0, bytes).has_value());
        CD_CHECK(store->finish_upload(std::move(begun)).has_value());
        // Depth 0 is what the master chooses where a job gives none. What a simulation made first
        // would take its time in that one alone.
        for (std::uint32_t depth = 0; depth <= 3; ++depth) {
            cuts.push_back(store->cut(mesh.hash(), depth).value());
        }
        return mesh.hash();
    }

    void add_grid(const Sha256& a, const Sha256& b) {
        Grid grid;
        grid.position = {GridAxis{-2.4, 2.4, 8}, GridAxis{-1.5, 1.5, 6}, GridAxis{0.1, 0.1, 1}};
        Submit submit;
        submit.bodies = {a, b};
        submit.scenarios = grid.count();
        submit.grid = encode_grid(grid);
        std::vector<Scenario> scenarios;
        for (std::uint64_t place = 0; place < grid.count(); ++place) {
            scenarios.push_back(scenario_on(grid, place));
        }
        add(std::move(submit), std::move(scenarios));
    }

    void add_list(
        const Sha256& a, const Sha256& b, std::uint64_t count, Level level, bool maps = false) {
        Submit submit;
        submit.bodies = {a, b};
        submit.query.level = level;
        submit.query.maps = maps;
        submit.scenarios = count;
        std::vector<Scenario> scenarios;
        for (std::uint64_t index = 0; index < count; ++index) {
            std::mt19937_64 random(index);
            Scenario scenario;
            scenario.index = index;
            scenario.poses.b = make_pose(random, 2);
            scenarios.push_back(scenario);
        }
        add(std::move(submit), std::move(scenarios));
    }

    void add(Submit submit, std::vector<Scenario> scenarios) {
        submit.name = "job " + std::to_string(jobs.size());
        const auto a = store->tree(submit.bodies[0]).value();
        const auto b = store->tree(submit.bodies[1]).value();
        std::vector<Sha256> digests;
        std::vector<std::vector<ContactPair>> pairs;
        for (const Scenario& scenario : scenarios) {
            const ScenarioRun run = run_scenario(*a, *b, scenario, submit.query);
            digests.push_back(digest_of(run.result));
            if (submit.query.maps) {
                pairs.push_back(run.found);
            }
        }
        jobs.push_back(
            {std::move(submit), std::move(scenarios), std::move(digests), std::move(pairs)});
    }
};

Known& known() {
    static Known made;
    return made;
}

} // namespace

std::span<const KnownJob> known_jobs() {
    return known().jobs;
}

const KnownJob& known_job(const std::string& name) {
    const auto found = std::ranges::find(
        known().jobs, name, [](const KnownJob& job) -> const auto& { return job.submit.name; });
    CD_CHECK(found != known().jobs.end());
    return *found;
}

GeometryStore& known_geometry() {
    return *known().store;
}

Sha256 digest_of_lost(const KnownJob& job, std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.level = job.submit.query.level;
    result.kind = ScenarioClass::Failed;
    result.failure = "scenario " + std::to_string(index) + ": lost with " +
                     std::to_string(limits::scenario_losses_max) + " workers, one after the other";
    return digest_of(result);
}

} // namespace cd::tests
