#include "client/folder/folder_exports.hpp"

#include "client/folder/kept_summary.hpp"
#include "common/job/result/merge.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace cd {

namespace {

/// The contact map to export: of a job with maps, the stored one; of another job, the sum over the
/// pairs in the records, or nothing below `level pairs`.
Result<std::optional<ContactMap>> map_of(const OpenedRun& run, ResultSink& sink) {
    const Query& query = run.manifest().query;
    if (query.maps || query.level < Level::Pairs) {
        return run.kept_map();
    }
    return std::optional(sink.map());
}

/// The report in summary.json; empty if the file is missing or damaged, since the records suffice.
RunReport kept_report(const OpenedRun& run) {
    auto report = read_summary(run.dir() / "summary.json");
    return report ? std::move(report.value()) : RunReport();
}

Result<RunReport>
write_exports(const OpenedRun& run, const SinkOptions& options, const ExportContext& context) {
    auto sink = ResultSink::open(options, context);
    if (!sink) {
        return sink.error();
    }
    ResultMerger merger(run.manifest().poses.count);
    const Status read = run.records().for_each([&](const KeptRecord& record) {
        static_cast<void>(merger.add(record.result, sha256(record.bytes)));
        return sink.value().add(record.result);
    });
    if (!read) {
        return read.error();
    }
    auto map = map_of(run, sink.value());
    if (!map) {
        return map.error();
    }
    if (Status finished = sink.value().finish(map.value()); !finished) {
        return finished.error();
    }
    RunReport report = kept_report(run);
    report.summary = merger.summary();
    report.digest = merger.digest();
    report.level = run.manifest().query.level;
    report.limit_pairs = run.manifest().query.limit_pairs;
    report.maps_all_pairs = run.manifest().query.maps;
    report.map = std::move(map.value());
    report.most_touched = sink.value().tally().most_touched();
    report.summary_file = (run.dir() / "summary.json").string();
    return report;
}

} // namespace

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
