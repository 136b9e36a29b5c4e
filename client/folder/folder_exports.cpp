#include "client/folder/folder_exports.hpp"

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/job/query.hpp"
#include "common/job/result/merge.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace cd {

namespace {

using Json = nlohmann::json;

Summary classes_of(const Json& json) {
    Summary summary;
    const std::array<std::pair<const char*, std::uint64_t*>, 14> counts{
        {{"total", &summary.total},
         {"separate", &summary.separate},
         {"touch", &summary.touch},
         {"cross", &summary.cross},
         {"inside", &summary.inside},
         {"contact", &summary.contact},
         {"undecided", &summary.undecided},
         {"failed", &summary.failed},
         {"near", &summary.near},
         {"near_pairs", &summary.near_pairs},
         {"pairs", &summary.pairs},
         {"surfaces_only", &summary.surfaces_only},
         {"insides_skipped", &summary.insides_skipped},
         {"cut", &summary.cut}}};
    for (const auto& [key, value] : counts) {
        *value = json.value(key, std::uint64_t{0});
    }
    return summary;
}

Query query_of(const Json& json) {
    Query query;
    query.level = level_from_text(json.value("level", "")).value_or(Level::Pairs);
    query.limit_pairs = json.value("limit_pairs", std::uint64_t{0});
    if (json.contains("clearance")) {
        query.clearance = json["clearance"].get<double>();
    }
    const std::string question = json.value("question", "");
    if (question == "shots") {
        query.question = Question::Shots;
    } else if (question == "motion") {
        query.question = Question::Motion;
    }
    return query;
}

RunReport report_of(const Json& json) {
    RunReport report;
    report.summary = classes_of(json);
    report.query = query_of(json);
    report.execution.seconds = json.value("seconds", 0.0);
    report.execution.resumed_at =
        std::min(json.value("resumed_at", std::uint64_t{0}), report.summary.merged());
    report.execution.reused = json.value("reused", std::uint64_t{0});
    report.execution.where = json.value("where", "");
    if (json.contains("digest") && json["digest"].is_string()) {
        report.digest = sha256_from_hex(json["digest"].get<std::string>());
    }
    if (json.contains("least_distance") && json["least_distance"].is_number()) {
        report.findings.least = LeastDistance{json["least_distance"].get<double>(),
                                              json.value("least_scenario", std::uint64_t{0}),
                                              json.value("unit", "")};
    }
    for (const Json& part : json.value("most_touched", Json::array())) {
        report.findings.most_touched.push_back(
            {part.value("part", ""), part.value("scenarios", std::uint64_t{0})});
    }
    return report;
}

/// Returns the contact map to export: the stored map of a job with maps; for other jobs the sum
/// over the pairs in the records, or nothing below `level pairs`.
Result<std::optional<ContactMap>> map_of(const OpenedRun& run, ResultSink& sink) {
    const Query& query = run.manifest().query;
    if (query.maps || query.level < Level::Pairs) {
        return run.kept_map();
    }
    return sink.map();
}

/// Reads the report in summary.json; empty if the file is missing or damaged, which does no harm.
RunReport kept_report(const OpenedRun& run) {
    auto report = read_summary(run.dir() / "summary.json");
    return report ? std::move(report.value()) : RunReport();
}

Result<RunReport>
write_exports(const OpenedRun& run, const SinkOptions& options, const ExportContext& context) {
    auto sink = CD_TRY(ResultSink::open(options, context));
    ResultMerger merger(run.manifest().poses.count, run.manifest().scene_head());
    CD_TRY(run.records().for_each([&](const RecordView& record) {
        static_cast<void>(merger.add(record.result, digest_of_record(record.bytes)));
        return sink.add(record.result);
    }));
    auto map = CD_TRY(map_of(run, sink));
    CD_TRY(sink.finish(map));
    RunReport report = kept_report(run);
    report.summary = merger.summary();
    report.digest = merger.digest();
    report.query = run.manifest().query;
    report.map = std::move(map);
    report.findings = sink.findings();
    report.folder.summary_file = (run.dir() / "summary.json").string();
    return report;
}

} // namespace

Result<RunReport> read_summary(const std::filesystem::path& path) {
    const std::string text = CD_TRY(read_file(path));
    try {
        return report_of(Json::parse(text));
    } catch (const Json::exception&) {
        return bad_input(path.string() + " is damaged, or no summary of cdctl");
    }
}

Result<RunReport> add_exports(const OpenedRun& run,
                              RunFolder* folder,
                              const ExportContext& context,
                              ExportOptions options) {
    const std::vector<std::string>& have = run.manifest().formats;
    if (!options.again) {
        std::erase_if(options.formats, [&](const std::string& format) {
            return std::ranges::find(have, format) != have.end();
        });
    }
    if (folder == nullptr) {
        return write_exports(run, {{}, {}, options.output}, context);
    }
    std::error_code error;
    std::filesystem::remove_all(folder->out(), error);
    const std::filesystem::path dir =
        options.formats.empty() ? std::filesystem::path() : folder->out();
    auto report = write_exports(run, {dir, options.formats, options.output}, context);
    if (!report || options.formats.empty()) {
        folder->clean();
        return report;
    }
    const Status added = folder->add_files(options.formats);
    return added ? std::move(report) : added.error();
}

} // namespace cd
