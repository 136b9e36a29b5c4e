#include "common/core/host/memory_limit.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>

namespace cd {

namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

/// Returns the number at the start of a file, or `unlimited` for other contents such as "max".
std::uint64_t number_in(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::uint64_t number = 0;
    return file >> number ? number : unlimited;
}

/// Returns the smallest number that `file` contains in a control group's folder and in its parents
/// up to `top`.
std::uint64_t
limit_up_to(const std::filesystem::path& top, const std::string& group, const char* file) {
    std::filesystem::path folder = top / std::filesystem::path(group).relative_path();
    std::uint64_t limit = number_in(top / file);
    while (folder != top && folder.has_relative_path()) {
        limit = std::min(limit, number_in(folder / file));
        folder = folder.parent_path();
    }
    return limit;
}

std::uint64_t limit_of_groups(const std::filesystem::path& root) {
    const std::filesystem::path groups = root / "sys/fs/cgroup";
    std::uint64_t limit = unlimited;
    std::ifstream file(root / "proc/self/cgroup");
    // Lines look like "0::/a/b" (version 2) or "4:memory:/a/b" (version 1).
    for (std::string line; std::getline(file, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) {
            continue;
        }
        const std::string kinds = "," + line.substr(first + 1, second - first - 1) + ",";
        const std::string group = line.substr(second + 1);
        if (kinds == ",,") {
            limit = std::min(limit, limit_up_to(groups, group, "memory.max"));
        } else if (kinds.find(",memory,") != std::string::npos) {
            limit = std::min(limit, limit_up_to(groups / "memory", group, "memory.limit_in_bytes"));
        }
    }
    return limit;
}

std::uint64_t memory_of_host(const std::filesystem::path& root) {
    std::ifstream file(root / "proc/meminfo");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string key;
        std::uint64_t kibibytes = 0;
        if (words >> key >> kibibytes && key == "MemTotal:") {
            return kibibytes * 1024;
        }
    }
    return unlimited;
}

} // namespace

std::uint64_t memory_limit(const std::filesystem::path& root) {
    return std::min(memory_of_host(root), limit_of_groups(root));
}

} // namespace cd
