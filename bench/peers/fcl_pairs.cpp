// Prints the pairs of triangles that FCL, in doubles, finds in contact.
//
//   fcl_pairs A B POSES
//
// A and B are meshes, POSES is a file as for `cdctl run --poses`, with a matrix for each pose. For
// each pose a line "A B A B ..." lists the triangles of each pair, sorted.
#include "bench/peers/engines/peers.hpp"
#include "client/import/mesh_import.hpp"
#include "client/poses/pose_file.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace cd::bench {

namespace {

Result<int> print_pairs(const char* file_a, const char* file_b, const char* file_poses) {
    const auto a = CD_TRY(import_mesh(file_a, {})).mesh;
    const auto b = CD_TRY(import_mesh(file_b, {})).mesh;
    PoseFileSpec spec;
    spec.path = file_poses;
    const auto poses = CD_TRY(open_pose_file(spec));
    const auto scenarios = CD_TRY(poses.source->read(0, poses.source->count()));
    std::vector<Engine> engines;
    add_fcl_double(engines);
    const auto engine = engines.front().make_meshes();
    engine->load(a, b);
    for (const Scenario& scenario : scenarios) {
        MeshAnswer answer = engine->ask(scenario.poses, Level::Pairs);
        std::ranges::sort(answer.pairs);
        for (const auto& [of_a, of_b] : answer.pairs) {
            std::printf("%u %u ", of_a, of_b);
        }
        std::printf("\n");
    }
    return 0;
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: fcl_pairs A B POSES\n");
        return 2;
    }
    const auto code = cd::bench::print_pairs(argv[1], argv[2], argv[3]);
    if (!code) {
        std::fprintf(stderr, "fcl_pairs: %s\n", code.error().detail.c_str());
    }
    return code ? code.value() : 2;
}
