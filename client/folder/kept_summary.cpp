#include "client/folder/kept_summary.hpp"

#include "common/job/query.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <utility>

namespace cd {

namespace {

using Json = nlohmann::json;

Summary classes_of(const Json& json) {
    Summary summary;
    const std::array<std::pair<const char*, std::uint64_t*>, 12> counts{
        {{"total", &summary.total},
         {"separate", &summary.separate},
         {"touch", &summary.touch},
         {"cross", &summary.cross},
         {"inside", &summary.inside},
         {"contact", &summary.contact},
         {"undecided", &summary.undecided},
         {"failed", &summary.failed},
         {"pairs", &summary.pairs},
         {"surfaces_only", &summary.surfaces_only},
         {"insides_skipped", &summary.insides_skipped},
         {"cut", &summary.cut}}};
    for (const auto& [key, value] : counts) {
        *value = json.value(key, std::uint64_t{0});
    }
    return summary;
}

RunReport report_of(const Json& json) {
    RunReport report;
    report.summary = classes_of(json);
    report.level = level_from_text(json.value("level", "")).value_or(Level::Pairs);
    report.limit_pairs = json.value("limit_pairs", std::uint64_t{0});
    report.execution.seconds = json.value("seconds", 0.0);
    report.execution.resumed_at =
        std::min(json.value("resumed_at", std::uint64_t{0}), report.summary.merged());
    report.execution.where = json.value("where", "");
    if (json.contains("digest") && json["digest"].is_string()) {
        report.digest = sha256_from_hex(json["digest"].get<std::string>());
    }
    for (const Json& part : json.value("most_touched", Json::array())) {
        report.most_touched.push_back(
            {part.value("part", ""), part.value("scenarios", std::uint64_t{0})});
    }
    return report;
}

} // namespace

Result<RunReport> read_summary(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return Error{ErrorCode::Io, path.string() + ": cannot be read"};
    }
    try {
        return report_of(Json::parse(file));
    } catch (const Json::exception&) {
        return Error{ErrorCode::BadInput, path.string() + " is damaged, or no summary of cdctl"};
    }
}

} // namespace cd
