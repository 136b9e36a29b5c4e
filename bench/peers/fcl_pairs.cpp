// Compares FCL's pairs of triangles with ours. The exact decision judges each difference.
//
//   fcl_pairs A B [--scenarios 50] [--seed 1] [--unit-a METRES] [--unit-b METRES]
//
// Prints a CSV row per scenario (our pairs and FCL's, FCL's missed and invented ones, times) and a
// summary. Exit code 1 if ours is ever wrong.
#include "client/import/mesh_import.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"

#include <CLI/CLI.hpp>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace cd {

namespace {

using FclModel = fcl::BVHModel<fcl::OBBd>;
using IdPair = std::pair<std::uint32_t, std::uint32_t>;

struct Options {
    std::string mesh_a;
    std::string mesh_b;
    double unit_a = 1;
    double unit_b = 1;
    std::uint64_t scenarios = 50;
    std::uint64_t seed = 1;
};

struct Totals {
    std::uint64_t ours = 0;
    std::uint64_t theirs = 0;
    std::uint64_t missed = 0;   ///< Missed by FCL, though the triangles share a point.
    std::uint64_t invented = 0; ///< Reported by FCL, though the triangles are apart.
    std::uint64_t scenarios_equal = 0;
    std::uint64_t ours_wrong = 0;
    double seconds_ours = 0;
    double seconds_theirs = 0;
};

std::shared_ptr<FclModel> make_fcl_model(const Mesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(mesh.triangles().size());
    for (const Triangle& t : mesh.triangles()) {
        triangles.emplace_back(t[0], t[1], t[2]);
    }
    auto model = std::make_shared<FclModel>();
    model->beginModel();
    model->addSubModel(mesh.vertices(), triangles);
    model->endModel();
    return model;
}

fcl::Transform3d to_fcl(const Pose& pose) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    transform.linear() = pose.rotation();
    transform.translation() = pose.translation();
    return transform;
}

std::set<IdPair> fcl_pairs(const FclModel& a, const FclModel& b, const PosePair& poses) {
    fcl::CollisionRequestd request;
    request.num_max_contacts = ~std::size_t{0};
    request.enable_contact = false;
    fcl::CollisionResultd result;
    fcl::collide(&a, to_fcl(poses.a), &b, to_fcl(poses.b), request, result);
    std::set<IdPair> pairs;
    for (std::size_t i = 0; i < result.numContacts(); ++i) {
        const fcl::Contactd& contact = result.getContact(i);
        pairs.emplace(static_cast<std::uint32_t>(contact.b1),
                      static_cast<std::uint32_t>(contact.b2));
    }
    return pairs;
}

template <class Function>
auto timed(double& seconds, const Function& function) {
    const auto start = std::chrono::steady_clock::now();
    auto result = function();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

/// Counts the pairs of `left` that `right` lacks, judged by the exact decision.
std::pair<std::uint64_t, std::uint64_t> judge(const std::set<IdPair>& left,
                                              const std::set<IdPair>& right,
                                              const Mesh& a,
                                              const Mesh& b,
                                              TrianglePairTest& test) {
    std::uint64_t touching = 0;
    std::uint64_t apart = 0;
    std::vector<IdPair> difference;
    std::set_difference(
        left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(difference));
    for (const auto& [ia, ib] : difference) {
        (test.classify(a.corners(ia), b.corners(ib)) != PairClass::Separate ? touching : apart) +=
            1;
    }
    return {touching, apart};
}

std::shared_ptr<const Mesh> load(const std::string& path, double unit) {
    ImportOptions options;
    options.unit_factor = unit;
    auto imported = import_mesh(path, options);
    if (!imported) {
        std::fprintf(stderr, "%s\n", imported.error().detail.c_str());
        std::exit(2);
    }
    return imported.value().mesh;
}

int compare(const Options& options) {
    ThreadPool pool;
    const auto mesh_a = load(options.mesh_a, options.unit_a);
    const auto mesh_b = load(options.mesh_b, options.unit_b);
    const ObbTree tree_a = build_tree(mesh_a, {}, pool);
    const ObbTree tree_b = build_tree(mesh_b, {}, pool);
    const auto model_a = make_fcl_model(*mesh_a);
    const auto model_b = make_fcl_model(*mesh_b);

    RandomPoses random;
    random.count = options.scenarios;
    random.seed = options.seed;
    Totals total;
    std::printf("scenario,pairs,fcl_pairs,fcl_missed,fcl_invented,ms,fcl_ms\n");
    for (const Scenario& scenario : make_random_poses(random, tree_a, tree_b, pool)) {
        double ours_seconds = 0;
        double theirs_seconds = 0;
        const ScenarioRun run =
            timed(ours_seconds, [&] { return run_scenario(tree_a, tree_b, scenario, Query{}); });
        const std::set<IdPair> theirs =
            timed(theirs_seconds, [&] { return fcl_pairs(*model_a, *model_b, scenario.poses); });
        std::set<IdPair> ours;
        for (const ContactPair& pair : run.result.pairs) {
            ours.emplace(pair.a, pair.b);
        }
        TrianglePairTest test(scenario.poses);
        const auto [missed, ours_invented] = judge(ours, theirs, *mesh_a, *mesh_b, test);
        const auto [ours_missed, invented] = judge(theirs, ours, *mesh_a, *mesh_b, test);
        total.ours += ours.size();
        total.theirs += theirs.size();
        total.missed += missed;
        total.invented += invented;
        total.ours_wrong += ours_invented + ours_missed;
        total.scenarios_equal += ours == theirs ? 1u : 0u;
        total.seconds_ours += ours_seconds;
        total.seconds_theirs += theirs_seconds;
        std::printf("%llu,%zu,%zu,%llu,%llu,%.3f,%.3f\n",
                    static_cast<unsigned long long>(scenario.index),
                    ours.size(),
                    theirs.size(),
                    static_cast<unsigned long long>(missed),
                    static_cast<unsigned long long>(invented),
                    1e3 * ours_seconds,
                    1e3 * theirs_seconds);
    }
    std::printf("scenarios %llu, equal in %llu; pairs %llu, FCL %llu; FCL missed %llu, invented "
                "%llu; ours wrong %llu; mean ms %.3f, FCL %.3f\n",
                static_cast<unsigned long long>(options.scenarios),
                static_cast<unsigned long long>(total.scenarios_equal),
                static_cast<unsigned long long>(total.ours),
                static_cast<unsigned long long>(total.theirs),
                static_cast<unsigned long long>(total.missed),
                static_cast<unsigned long long>(total.invented),
                static_cast<unsigned long long>(total.ours_wrong),
                1e3 * total.seconds_ours / static_cast<double>(options.scenarios),
                1e3 * total.seconds_theirs / static_cast<double>(options.scenarios));
    return total.ours_wrong == 0 ? 0 : 1;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app("Compares our pairs with FCL's and puts each difference to the exact decision");
    app.add_option("A", options.mesh_a, "Mesh of the fixed body")->required();
    app.add_option("B", options.mesh_b, "Mesh of the moved body")->required();
    app.add_option("--scenarios", options.scenarios, "Random scenarios of the paper's kind");
    app.add_option("--seed", options.seed, "Their seed");
    app.add_option("--unit-a", options.unit_a, "Metres in a unit of A's file");
    app.add_option("--unit-b", options.unit_b, "Metres in a unit of B's file");
    CLI11_PARSE(app, argc, argv);
    return cd::compare(options);
}
