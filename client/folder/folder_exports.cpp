#include "client/folder/folder_exports.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace cd {

namespace {

/// The map that the files show: the one that was kept, or the sum of the records' pairs.
Result<std::optional<ContactMap>> map_of(const OpenedRun& run, ResultSink& sink) {
    const Query& query = run.manifest().query;
    if (query.maps || query.level < Level::Pairs) {
        return run.kept_map();
    }
    return std::optional(sink.map());
}

} // namespace

Result<Summary> add_exports(const OpenedRun& run,
                            RunFolder& folder,
                            const ExportContext& context,
                            ExportOptions options) {
    const std::vector<std::string>& have = run.manifest().formats;
    if (!options.again) {
        std::erase_if(options.formats, [&](const std::string& format) {
            return std::ranges::find(have, format) != have.end();
        });
    }
    std::error_code error;
    std::filesystem::remove_all(folder.out(), error);
    const std::filesystem::path dir =
        options.formats.empty() ? std::filesystem::path() : folder.out();
    auto sink = ResultSink::open({dir, options.formats, options.output}, context);
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
    const auto map = map_of(run, sink.value());
    if (!map) {
        return map.error();
    }
    if (Status finished = sink.value().finish(map.value()); !finished) {
        return finished.error();
    }
    if (options.formats.empty()) {
        folder.clean();
        return merger.summary();
    }
    if (Status added = folder.add_files(options.formats); !added) {
        return added.error();
    }
    return merger.summary();
}

} // namespace cd
