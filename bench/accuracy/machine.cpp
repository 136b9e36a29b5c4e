#include "bench/accuracy/machine.hpp"

#include "bench/accuracy/csv.hpp"
#include "common/core/version.hpp"
#include "common/geometry/simd_target.hpp"

#include <fstream>
#include <thread>

namespace cd::bench {

namespace {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    return "unknown";
}

} // namespace

void write_machine(const std::filesystem::path& folder, std::span<const std::string> missing) {
    CsvFile csv(folder / "machine.csv", {"what", "value"});
    csv.row({"processor", processor()});
    csv.row({"hardware threads", std::to_string(std::thread::hardware_concurrency())});
    std::string targets;
    for (const SimdTarget target : available_simd_targets()) {
        targets += (targets.empty() ? "" : " ") + std::string(to_text(target));
    }
    csv.row({"SIMD targets", targets});
    csv.row({"SIMD target in use", std::string(to_text(simd_target()))});
    csv.row({"compiler", "GCC " __VERSION__});
    csv.row({"cdcluster", std::string(version)});
    for (const std::string& peer : missing) {
        csv.row({"not installed", peer});
    }
}

} // namespace cd::bench
