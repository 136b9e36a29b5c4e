#include "tests/fuzz/targets.hpp"

#include <array>

namespace cd::fuzz {

std::span<const Target> targets() {
    static constexpr std::array list{
        Target{"frames", frames},
        Target{"message", message},
        Target{"token", token},
        Target{"mesh", mesh},
        Target{"certificate", certificate},
        Target{"certificate_request", certificate_request},
        Target{"http", http},
        Target{"block", block},
        Target{"top", top},
        Target{"sent_block", sent_block},
        Target{"result", result},
        Target{"packed", packed},
        Target{"map", map},
        Target{"journal_row", journal_row},
        Target{"segment", segment},
        Target{"grid", grid},
        Target{"scenarios", scenarios},
        Target{"job_file", job_file},
        Target{"csv_poses", csv_poses},
        Target{"tum_poses", tum_poses},
        Target{"fcd", fcd},
        Target{"npy", npy},
        Target{"npz", npz},
        Target{"gltf", gltf},
        Target{"stl", stl},
        Target{"obj", obj},
        Target{"ply", ply},
        Target{"off", off},
        Target{"mesh_text", mesh_text},
        Target{"tokens", tokens},
        Target{"pose_spool", pose_spool},
        Target{"tree_file", tree_file},
        Target{"record_file", record_file},
        Target{"run_json", run_json},
        Target{"labels", labels},
    };
    return list;
}

} // namespace cd::fuzz
