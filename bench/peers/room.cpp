#include "bench/peers/room.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>

namespace cd::bench {

namespace {

/// With fewer triangles, memory of constant size dominates.
constexpr std::uint64_t triangles_enough = 100000;
/// Assumed ratio of an engine's memory while building to what it keeps.
constexpr double while_building = 2;
constexpr double share_of_memory = 0.8;

/// Returns infinity if the system does not report it.
double available_bytes() {
    std::ifstream file("/proc/meminfo");
    for (std::string word; file >> word;) {
        if (word == "MemAvailable:") {
            double kilobytes = 0;
            file >> kilobytes;
            return 1024 * kilobytes;
        }
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

void Room::learn(std::span<const Outcome> outcomes, std::uint64_t triangles) {
    for (const Outcome& outcome : outcomes) {
        if (triangles >= triangles_enough && outcome.memory_bytes > 0) {
            bytes_a_triangle_[outcome.engine->name] =
                static_cast<double>(outcome.memory_bytes) / static_cast<double>(triangles);
        }
    }
}

std::vector<Engine> Room::fitting(std::span<const Engine> engines, std::uint64_t triangles) const {
    const double room = share_of_memory * available_bytes();
    std::vector<Engine> fitting;
    double kept = 0;
    double building = 0;
    for (const Engine& engine : engines) {
        const auto known = bytes_a_triangle_.find(engine.name);
        const double bytes =
            known == bytes_a_triangle_.end() ? 0 : known->second * static_cast<double>(triangles);
        const double building_too = std::max(building, (while_building - 1) * bytes);
        if (!fitting.empty() && kept + bytes + building_too > room) {
            std::fprintf(stderr, "no room in memory for %s: no row\n", engine.name.c_str());
            continue;
        }
        kept += bytes;
        building = building_too;
        fitting.push_back(engine);
    }
    return fitting;
}

} // namespace cd::bench
