// Checks a state directory and reports all damage. Changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

struct StateReport {
    std::vector<std::string> lines; ///< Human-readable contents and damaged files.
    bool is_sound = true;
};

/// Reads the journal, all result records and poses, the meshes against their hashes, and the
/// identity. Skips trees and blocks, which the master can rebuild from the meshes. A directory that
/// a master uses cannot be checked and counts as not sound.
[[nodiscard]] StateReport check_state(const std::filesystem::path& directory);

} // namespace cd
