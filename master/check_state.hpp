// Looks through a state directory and tells all that is wrong with it. Changes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cd {

struct StateReport {
    std::vector<std::string> lines; ///< For people: what is there, and each file that is damaged.
    bool is_sound = true;
};

/// Reads every byte that matters: the journal, all records of results, poses, meshes against their
/// hashes, and the identity. Trees and blocks are not looked at: they are made again from the
/// meshes. A directory that a master uses cannot be checked, and counts as not sound.
[[nodiscard]] StateReport check_state(const std::filesystem::path& directory);

} // namespace cd
