// Records the costs of a job of random poses, for `simulate`. See README.md.
//
//   record_trace MESH_A MESH_B OUT --name heavy --count 3744 [--depths 2 4 6 ...] [--passes 3]
#include "bench/cluster/trace/recorder.hpp"
#include "client/import/mesh_import.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/poses/random_poses.hpp"
#include "common/tree/build/build.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path a;
    std::filesystem::path b;
    std::filesystem::path out;
    RandomPoses poses;
    RecordOptions record;
};

Result<std::shared_ptr<const ObbTree>> tree_of(const std::filesystem::path& path,
                                               ThreadPool& pool) {
    const auto mesh = import_mesh(path, {});
    if (!mesh) {
        return mesh.error();
    }
    BuildOptions build;
    build.prepare_search = false;
    return std::make_shared<const ObbTree>(build_tree(mesh.value().mesh, build, pool));
}

std::vector<Scenario> scenarios_of(const ObbTree& a, const ObbTree& b, const RandomPoses& poses) {
    ThreadPool pool(1);
    ObbTree wide_a = a;
    ObbTree wide_b = b;
    wide_a.prepare_search(&pool);
    wide_b.prepare_search(&pool);
    return make_random_poses(poses, wide_a, wide_b, pool);
}

Status run(Options options) {
    std::filesystem::create_directories(options.out.parent_path());
    options.record.scratch = options.out.parent_path();
    ThreadPool pool(1);
    const auto a = tree_of(options.a, pool);
    const auto b = tree_of(options.b, pool);
    for (const auto* tree : {&a, &b}) {
        if (!*tree) {
            return tree->error();
        }
    }
    const auto scenarios = scenarios_of(*a.value(), *b.value(), options.poses);
    const auto trace = record_trace(a.value(), b.value(), scenarios, options.record);
    return trace ? write_trace(options.out, trace.value()) : Status(trace.error());
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.record.depths_a = {2, 4, 6, 8, 10, 12, 14};
    CLI::App app("Records what the scenarios and subtrees of a job cost");
    app.add_option("MESH_A", options.a, "The fixed body")->required();
    app.add_option("MESH_B", options.b, "The other")->required();
    app.add_option("OUT", options.out, "The trace to write, in a folder for scratch")->required();
    app.add_option("--name", options.record.name, "Of the trace")->required();
    app.add_option("--count", options.poses.count, "Random poses")->check(CLI::PositiveNumber);
    app.add_option("--seed", options.poses.seed, "Of the poses");
    app.add_option("--depths", options.record.depths_a, "At which A is cut, ascending");
    app.add_option("--depth-b", options.record.depth_b, "At which B is cut");
    app.add_option("--passes", options.record.passes, "Over all scenarios")
        ->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        const cd::Status status = cd::bench::run(options);
        if (!status) {
            std::fprintf(stderr, "%s\n", status.error().detail.c_str());
            return 2;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
