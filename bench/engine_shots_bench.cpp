// Measures shot lines through a mesh: the search for the triangles that lines touch, and the exact
// decision of each hit.
//
//   engine_shots_bench MESH [--unit 1] [--lines 128] [--rounds 3] [--only front]
//
// Lines are those of a grid of about lines x lines from the front and from an odd direction, in
// bundles of 64 x 64 as in a job, and one bundle of as many lines through the mesh's vertices.
// Prints for each kind the least time of some rounds: of the search alone, of the whole run with
// depths, and of the decisions alone, for each hit. A line with an odd number of crossings starts
// or ends inside of the mesh, or the mesh is open.
#include "bench/timed_work.hpp"
#include "client/bundle/bundle_poses.hpp"
#include "client/bundle/line_bundle.hpp"
#include "client/import/mesh_import.hpp"
#include "common/job/run_scenario.hpp"
#include "common/shots/segment_hit.hpp"
#include "common/tree/build/build.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    std::string mesh;
    double unit = 1;
    std::uint32_t lines = 128;
    int rounds = 3;
    std::string only;
};

/// A bundle of lines, and where it is.
struct Kind {
    std::string name;
    Mesh lines;
    std::vector<Pose> poses;
};

/// Returns parallel lines through random vertices of a mesh. The direction has few digits, so that
/// lines pass through most vertices exactly.
Mesh lines_through_vertices(const Mesh& mesh, std::uint32_t count, double reach) {
    std::mt19937_64 random(1);
    const Vec3 step = 4 * reach * Vec3(0.5, 0.25, 0.375);
    std::vector<LineEnds> lines;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3& vertex = mesh.vertices()[random() % mesh.vertices().size()];
        lines.push_back({vertex + step, vertex - step});
    }
    return line_mesh(lines).value();
}

std::vector<Kind> kinds_of(const Mesh& mesh, const Options& options) {
    const Aabb box = bounding_box(mesh.vertices());
    const double reach = bundle_reach(box);
    LineGrid grid;
    grid.spacing = box.diagonal() / options.lines;
    const Mesh bundle = make_bundle(grid, reach).value();
    const auto from = [&](const ShotView& view) {
        std::vector<Pose> poses;
        const std::vector<BundlePose> places = bundle_poses(grid, {&view, 1}, box).value();
        for (const BundlePose& place : places) {
            poses.push_back(place.pose);
        }
        return poses;
    };
    return {
        {"front", bundle, from({0, 0})},
        {"odd direction", bundle, from({33, 17})},
        {"vertices", lines_through_vertices(mesh, options.lines * options.lines, reach), {Pose()}}};
}

/// Returns the least time of some rounds.
template <class Work>
double least_seconds(int rounds, const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < rounds; ++round) {
        const double start = processor_seconds();
        work();
        least = std::min(least, processor_seconds() - start);
    }
    return least;
}

std::vector<ScenarioResult>
run_lines(const ObbTree& body, const ObbTree& lines, const std::vector<Pose>& poses, Level level) {
    Query query;
    query.level = level;
    query.question = Question::Shots;
    const ScenarioRunner runner(body, lines, query);
    ScenarioSession session(runner);
    std::vector<ScenarioResult> results;
    Scenario scenario;
    for (const Pose& pose : poses) {
        scenario.poses.b = pose;
        results.push_back(session.run(scenario).result);
    }
    return results;
}

/// The triangles that each line touches.
struct Touched {
    Segment line;
    std::vector<Corners> triangles;
};

std::vector<Touched> touched_of(const Mesh& mesh, const Mesh& lines, const ScenarioResult& result) {
    std::map<std::uint32_t, Touched> by_line;
    for (const ContactPair& pair : result.pairs) {
        const Corners ends = lines.corners(pair.b);
        Touched& touched = by_line[pair.b];
        touched.line = {ends[0], ends[1]};
        touched.triangles.push_back(mesh.corners(pair.a));
    }
    std::vector<Touched> all;
    for (auto& [line, touched] : by_line) {
        all.push_back(std::move(touched));
    }
    return all;
}

struct Decided {
    HitStatistics statistics;
    std::uint64_t crossings = 0;
    std::uint64_t odd_lines = 0;
};

void decide(const std::vector<Touched>& touched, const Pose& pose, Decided& decided) {
    SegmentHit engine({Pose(), pose});
    for (const Touched& each : touched) {
        std::uint64_t crossings = 0;
        for (const LineHit& hit : engine.hits(each.triangles, each.line)) {
            crossings += (hit.flags & hit_flag::crosses) != 0 ? 1u : 0u;
        }
        decided.crossings += crossings;
        decided.odd_lines += crossings % 2;
    }
    decided.statistics += engine.statistics();
}

void measure(const Mesh& mesh, const ObbTree& body, const Kind& kind, int rounds) {
    ThreadPool pool;
    const ObbTree lines = build_tree(std::make_shared<const Mesh>(kind.lines), {}, pool);
    std::vector<ScenarioResult> results;
    const double search =
        least_seconds(rounds, [&] { results = run_lines(body, lines, kind.poses, Level::Count); });
    const double whole =
        least_seconds(rounds, [&] { results = run_lines(body, lines, kind.poses, Level::Pairs); });
    std::vector<std::vector<Touched>> touched;
    double hits = 0;
    for (const ScenarioResult& result : results) {
        if (result.kind == ScenarioClass::Failed) {
            std::printf("%-14s %s\n", kind.name.c_str(), result.failure.c_str());
            return;
        }
        touched.push_back(touched_of(mesh, kind.lines, result));
        hits += static_cast<double>(result.pair_count);
    }
    Decided decided;
    const double decisions = least_seconds(rounds, [&] {
        decided = {};
        for (std::size_t i = 0; i < touched.size(); ++i) {
            decide(touched[i], kind.poses[i], decided);
        }
    });
    const auto count = static_cast<double>(kind.lines.triangles().size() * kind.poses.size());
    std::printf("%-14s %8.0f lines %9.0f hits %9llu crossings %6llu odd lines  search %6.2f, whole "
                "%6.2f M lines/s  %7.0f ns a hit",
                kind.name.c_str(),
                count,
                hits,
                static_cast<unsigned long long>(decided.crossings),
                static_cast<unsigned long long>(decided.odd_lines),
                1e-6 * count / search,
                1e-6 * count / whole,
                1e9 * decisions / std::max(hits, 1.0));
    for (std::size_t i = 0; i < hit_stage_count; ++i) {
        const auto stage = static_cast<HitStage>(i);
        std::printf("  %s %llu + %llu",
                    std::string(to_text(stage)).c_str(),
                    static_cast<unsigned long long>(decided.statistics.decisions[i]),
                    static_cast<unsigned long long>(decided.statistics.depths[i]));
    }
    std::printf("  alike %llu\n", static_cast<unsigned long long>(decided.statistics.ties));
}

int run(const Options& options) {
    const auto imported = import_mesh(options.mesh, {options.unit});
    if (!imported) {
        std::fprintf(stderr, "%s\n", imported.error().detail.c_str());
        return 1;
    }
    const std::shared_ptr<const Mesh> mesh = imported.value().mesh;
    ThreadPool pool;
    const ObbTree body = build_tree(mesh, {}, pool);
    for (const Kind& kind : kinds_of(*mesh, options)) {
        if (kind.name.find(options.only) == std::string::npos) {
            continue;
        }
        measure(*mesh, body, kind, options.rounds);
    }
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    CLI::App app("Measures shot lines through a mesh.");
    app.add_option("MESH", options.mesh, "A mesh file")->required();
    app.add_option("--unit", options.unit, "What coordinates are multiplied by");
    app.add_option("--lines", options.lines, "Lines along a side of the bundle")
        ->capture_default_str();
    app.add_option("--only", options.only, "Kinds of lines with this in their names");
    app.add_option("--rounds", options.rounds, "The least time counts")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return cd::bench::run(options);
}
