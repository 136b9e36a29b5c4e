#include "client/import/gltf_check.hpp"

#include "client/import/mesh_words.hpp"
#include "common/core/limits.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace cd {

namespace {

using Json = nlohmann::json;

Error bad(const std::filesystem::path& path, std::size_t node, const std::string& detail) {
    return {ErrorCode::BadInput, path.string() + ": node " + std::to_string(node) + ": " + detail};
}

/// The JSON of a glTF file: the file itself, or the first chunk of a GLB.
std::string gltf_json(const std::filesystem::path& path, bool is_glb) {
    std::ifstream in(path, std::ios::binary);
    if (is_glb) {
        constexpr std::size_t header = 20; // Of the file, and of the first chunk.
        std::array<char, header> begin{};
        if (!in.read(begin.data(), begin.size())) {
            return {};
        }
        std::uint64_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            size |= std::uint64_t{static_cast<unsigned char>(begin[12 + i])} << (8 * i);
        }
        std::error_code error;
        // Checked before the allocation: the file chooses this number.
        if (size > std::filesystem::file_size(path, error) || error) {
            return {};
        }
        std::string text(size, '\0');
        in.read(text.data(), static_cast<std::streamsize>(size));
        return text;
    }
    return read_text(path);
}

bool holds_numbers(const Json& list) {
    return std::all_of(list.begin(), list.end(), [](const Json& e) { return e.is_number(); });
}

Status check_transforms(const std::filesystem::path& path, const Json& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const char* key : {"matrix", "translation", "rotation", "scale"}) {
            const bool has_key = nodes[i].is_object() && nodes[i].contains(key);
            if (has_key && !holds_numbers(nodes[i][key])) {
                return bad(path, i, "its " + std::string(key) + " holds what is not a number");
            }
        }
    }
    return Done{};
}

/// The nodes that a list names, and that there are.
std::vector<std::size_t> named_nodes(const Json& owner, const char* key, std::size_t count) {
    std::vector<std::size_t> named;
    if (owner.is_object() && owner.contains(key) && owner[key].is_array()) {
        for (const auto& entry : owner[key]) {
            const bool is_node = entry.is_number_unsigned() && entry.get<std::uint64_t>() < count;
            if (is_node) {
                named.push_back(entry.get<std::size_t>());
            }
        }
    }
    return named;
}

/// A node has one parent (glTF 2.0, section 3.5.2); else a few nodes could stand for 2^1000.
Status check_nesting(const std::filesystem::path& path, const Json& json) {
    const Json& nodes = json["nodes"];
    std::vector<std::vector<std::size_t>> children(nodes.size());
    std::vector<bool> is_child(nodes.size(), false);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        children[i] = named_nodes(nodes[i], "children", nodes.size());
        for (const std::size_t child : children[i]) {
            if (is_child[child]) {
                return bad(path, child, "is the child of two nodes");
            }
            is_child[child] = true;
        }
    }
    std::vector<std::size_t> level;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!is_child[i]) {
            level.push_back(i);
        }
    }
    if (json.contains("scenes") && json["scenes"].is_array()) {
        for (const auto& scene : json["scenes"]) {
            const auto named = named_nodes(scene, "nodes", nodes.size());
            level.insert(level.end(), named.begin(), named.end()); // A cycle has no other begin.
        }
    }
    // Each once, however often scenes name it: then no level has more nodes than there are.
    std::ranges::sort(level);
    level.erase(std::unique(level.begin(), level.end()), level.end());
    for (std::size_t depth = 1; !level.empty(); ++depth) {
        if (depth > limits::mesh_file_depth_max) {
            return bad(path,
                       level.front(),
                       "is nested more than " + std::to_string(limits::mesh_file_depth_max) +
                           " deep");
        }
        std::vector<std::size_t> next;
        for (const std::size_t node : level) {
            next.insert(next.end(), children[node].begin(), children[node].end());
        }
        level = std::move(next);
    }
    return Done{};
}

} // namespace

Status check_gltf(const std::filesystem::path& path, bool is_glb) {
    const Json json = Json::parse(gltf_json(path, is_glb), nullptr, false);
    if (!json.is_object() || !json.contains("nodes") || !json["nodes"].is_array()) {
        return Done{}; // The importer says what is wrong with it, if anything is.
    }
    Status transforms = check_transforms(path, json["nodes"]);
    return transforms ? check_nesting(path, json) : transforms;
}

} // namespace cd
