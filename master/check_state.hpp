// Checks a state directory and reports all damage. Changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

struct StateReport {
    std::vector<std::string> lines; ///< Text for people: the contents, and each damaged file.
    bool is_sound = true;
};

/// Reads and checks the journal, all result records, poses and labels, the meshes, the blocks, and
/// the identity. Skips trees, which the master can rebuild from the meshes. A directory that a
/// running master uses cannot be checked and counts as not sound.
[[nodiscard]] StateReport check_state(const std::filesystem::path& directory);

} // namespace cd
