#include "tests/faults/jobs.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/motion/motion_keys.hpp"
#include "master/journal/job_map.hpp"
#include "tests/faults/world.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace cd::tests {

namespace {

Query at_level(Level level, bool maps = false) {
    Query query;
    query.level = level;
    query.maps = maps;
    return query;
}

Query with_clearance(Level level, double clearance) {
    Query query = at_level(level);
    query.clearance = clearance;
    return query;
}

Query of_distance() {
    Query query = at_level(Level::Any);
    query.question = Question::Distance;
    return query;
}

Query of_lines() {
    Query query = at_level(Level::Count, true);
    query.question = Question::Shots;
    return query;
}

Query of_motions(Level level) {
    Query query = at_level(level);
    query.question = Question::Motion;
    query.motion = MotionQuery{0.05, Until::Contact};
    return query;
}

/// Makes a square of lines through the middle.
Mesh some_lines() {
    MeshArrays arrays;
    for (std::uint32_t i = 0; i < 64; ++i) {
        const double y = (i % 8) / 4.0 - 0.875;
        const double z = (i / 8) / 4.0 - 0.875;
        arrays.vertices.emplace_back(4, y, z);
        arrays.vertices.emplace_back(-4, y, z);
        arrays.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 1});
    }
    return Mesh::create(std::move(arrays)).value();
}

/// All of it is made before the first simulation, outside of any.
struct Known {
    TemporaryFolder folder; ///< Stays empty; the files are in memory.
    ThreadPool pool{1};
    std::unique_ptr<GeometryStore> store;
    std::vector<Sha256> meshes;
    std::vector<std::shared_ptr<const CutGeometry>> cuts; ///< Keeps the cuts in memory.
    std::vector<KnownJob> jobs;
    std::optional<KnownJob> large;
    Sha256 sphere;
    Sha256 torus;

    Known() {
        for (const char* name : {"meshes", "trees", "blocks"}) {
            std::filesystem::create_directories(folder / name);
        }
        store = std::move(GeometryStore::open(folder.path(), pool).value());
        sphere = upload(make_sphere(2));
        torus = upload(in_parts(make_torus(1, 0.4, 12, 8), 5));
        const Sha256 box = upload(make_gridded_box({1, 2, 1}, 3));
        jobs.push_back(grid_job(torus, sphere, {8, 6, 1}));
        add_list(torus, box, 70, at_level(Level::Contacts));
        add_list(sphere, box, 330, at_level(Level::Any));
        add_list(sphere, sphere, 24, at_level(Level::Count));
        add_list(torus, sphere, 200, at_level(Level::Count, true));
        add_list(torus, box, 60, with_clearance(Level::Count, 0.2));
        add_list(sphere, box, 60, of_distance());
        add_list(torus, upload(some_lines()), 60, of_lines());
        add_motions(torus, sphere, 40, of_motions(Level::Any));
        add_motions(sphere, box, 20, of_motions(Level::Pairs));
        add_scene({torus, box, sphere, torus}, 20, at_level(Level::Pairs));
    }

    Sha256 upload(const Mesh& mesh) {
        const Bytes bytes = mesh.canonical_bytes();
        auto begun = std::move(store->begin_upload(mesh.hash(), "mesh", bytes.size()).value());
        CD_CHECK(begun->append(0, bytes).has_value());
        CD_CHECK(store->finish_upload(std::move(begun)).has_value());
        meshes.push_back(mesh.hash());
        cut(mesh.hash());
        return mesh.hash();
    }

    // Depth 0 is the master's choice if a job gives none. If a simulation made it first, it would
    // take time in that simulation alone.
    void cut(const Sha256& mesh) {
        for (std::uint32_t depth = 0; depth <= 3; ++depth) {
            cuts.push_back(store->cut(mesh, depth).value());
        }
    }

    const KnownJob& make_large() {
        if (!large) {
            large = grid_job(torus, sphere, {20, 15, 10});
        }
        return *large;
    }

    KnownJob grid_job(const Sha256& a, const Sha256& b, const std::array<std::uint32_t, 3>& steps) {
        Grid grid;
        grid.position = {GridAxis{-2.4, 2.4, steps[0]},
                         GridAxis{-1.5, 1.5, steps[1]},
                         GridAxis{0.1, steps[2] == 1 ? 0.1 : 1.1, steps[2]}};
        Submit submit;
        submit.bodies = {{a}, {b}};
        submit.scenarios = grid.count();
        submit.grid = encode_grid(grid);
        submit.poses.kind = PosesKind::Grid;
        std::vector<Scenario> scenarios;
        for (std::uint64_t place = 0; place < grid.count(); ++place) {
            scenarios.push_back(scenario_on(grid, place));
        }
        return make(std::move(submit), std::move(scenarios));
    }

    void add_list(const Sha256& a, const Sha256& b, std::uint64_t count, const Query& query) {
        Submit submit;
        submit.bodies = {{a}, {b}};
        submit.query = query;
        submit.scenarios = count;
        std::vector<Scenario> scenarios;
        for (std::uint64_t index = 0; index < count; ++index) {
            std::mt19937_64 random(index);
            Scenario scenario;
            scenario.index = index;
            scenario.poses.b = make_pose(random, 2);
            scenarios.push_back(scenario);
        }
        jobs.push_back(make(std::move(submit), std::move(scenarios)));
    }

    /// Moves B from each random pose to the next.
    void add_motions(const Sha256& a, const Sha256& b, std::uint64_t count, const Query& query) {
        Submit submit;
        submit.bodies = {{a}, {b}};
        submit.query = query;
        submit.scenarios = count;
        std::vector<PosePair> poses;
        for (std::uint64_t index = 0; index <= count; ++index) {
            std::mt19937_64 random(index);
            const Quaternion turn{1, 0, 0, 0.1 * static_cast<double>(index % 5)};
            poses.push_back({Pose::from_quaternion({}, Vec3::Zero()),
                             Pose::from_quaternion(turn, make_pose(random, 3).translation())});
        }
        const auto radius = [&](const Sha256& mesh) {
            return body_radius(store->tree(mesh).value()->mesh().vertices());
        };
        const auto keys =
            round_keys(poses, {radius(a), radius(b)}, query.motion->resolution).value().keys;
        std::vector<Scenario> scenarios(count);
        for (std::uint64_t index = 0; index < count; ++index) {
            scenarios[index].index = index;
            scenarios[index].poses = keys[index];
            scenarios[index].to = keys[index + 1];
        }
        jobs.push_back(make(std::move(submit), std::move(scenarios)));
    }

    /// Tests all pairs of bodies at each step, at random poses.
    void add_scene(const std::vector<Sha256>& bodies, std::uint64_t steps, const Query& query) {
        Submit submit;
        for (const Sha256& body : bodies) {
            submit.bodies.push_back({body});
        }
        submit.query = query;
        submit.poses.scene.emplace();
        std::vector<Scenario> scenarios;
        for (std::uint64_t step = 0; step < steps; ++step) {
            std::mt19937_64 random(step);
            std::vector<Pose> poses;
            for (std::size_t body = 0; body < bodies.size(); ++body) {
                poses.push_back(make_pose(random, 2));
            }
            for (std::uint32_t a = 0; a < bodies.size(); ++a) {
                for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
                    scenarios.push_back(
                        {scenarios.size(), a, b, PosePair{poses[a], poses[b]}, step});
                }
            }
        }
        submit.scenarios = scenarios.size();
        jobs.push_back(make(std::move(submit), std::move(scenarios)));
    }

    KnownJob make(Submit submit, std::vector<Scenario> scenarios) {
        submit.name = "job " + std::to_string(jobs.size());
        BodyTrees trees;
        for (const JobBody& body : submit.bodies) {
            trees.push_back(store->tree(body.mesh).value());
        }
        const ScenarioRunner runner(TreesByBody(trees), submit.query);
        std::vector<Sha256> digests;
        std::vector<std::vector<ContactPair>> pairs;
        for (const Scenario& scenario : scenarios) {
            const ScenarioRun run = runner.run(scenario);
            digests.push_back(digest_of(run.result));
            if (sums_contacts(submit)) {
                pairs.push_back(submit.query.maps ? run.found : run.result.pairs);
            }
        }
        return {std::move(submit),
                std::move(scenarios),
                std::move(digests),
                std::move(pairs),
                body_part_runs(trees[0]->mesh(), trees[1]->mesh())};
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
    if (known().large && name == known().large->submit.name) {
        return *known().large;
    }
    const auto found = std::ranges::find(
        known().jobs, name, [](const KnownJob& job) -> const auto& { return job.submit.name; });
    CD_CHECK(found != known().jobs.end());
    return *found;
}

const KnownJob& large_job() {
    return known().make_large();
}

GeometryStore& known_geometry() {
    return *known().store;
}

void lose_known_blocks(World& world) {
    known().cuts.clear();
    SimulatedFiles& files = safe_files().by_path;
    for (auto file = files.begin(); file != files.end();) {
        const bool is_hit = file->first.find("/blocks/") != std::string::npos && world.happens(500);
        if (is_hit && world.happens(500)) {
            file = files.erase(file);
            continue;
        }
        if (is_hit) {
            // Open readers keep the old contents.
            file->second = std::make_shared<SimulatedFile>(*file->second);
            file->second->content.resize(world.below(file->second->content.size() + 1));
        }
        ++file;
    }
}

void keep_known_blocks() {
    if (known().cuts.empty()) {
        for (const Sha256& mesh : known().meshes) {
            known().cut(mesh);
        }
    }
}

Sha256 digest_of_lost(const KnownJob& job, std::uint64_t index) {
    const Scenario& scenario = job.scenarios.at(index);
    ScenarioResult result;
    result.index = index;
    result.body_a = scenario.body_a;
    result.body_b = scenario.body_b;
    result.step = scenario.step;
    result.level = job.submit.query.level;
    result.question = job.submit.query.question;
    result.has_clearance = job.submit.query.clearance.has_value();
    result.kind = ScenarioClass::Failed;
    result.failure = "scenario " + std::to_string(index) + ": lost with " +
                     std::to_string(limits::scenario_losses_max) +
                     " workers, one after the other, or with fewer again and again";
    return digest_of(result);
}

} // namespace cd::tests
