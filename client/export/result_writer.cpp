#include "client/export/result_writer.hpp"

#include "client/export/map_files.hpp"
#include "client/spec/job_file.hpp"

#include <algorithm>

namespace cd {

namespace {

/// The file name of a format with a single file.
std::string file_of(std::string_view format) {
    return format == "csv" ? "scenarios.csv" : format == "text" ? "results.txt" : "results.jsonl";
}

Result<std::unique_ptr<ResultWriter>> make_writer(const std::string& format,
                                                  const ExportContext& context,
                                                  const std::filesystem::path& dir) {
    if (format == "csv-pairs") {
        return make_pairs_csv_writer(context, dir);
    }
    if (format == "npz") {
        return make_npz_writer(context, dir);
    }
    if (Status known = check_format(format); !known) {
        return known.error();
    }
    auto file = OutputFile::create(dir / file_of(format));
    if (!file) {
        return file.error();
    }
    return format == "csv"    ? make_scenarios_csv_writer(context, std::move(file.value()))
           : format == "text" ? make_text_writer(context, std::move(file.value()))
                              : make_json_writer(context, std::move(file.value()));
}

} // namespace

void ExportContext::describe(const Query& query) {
    level = query.level;
    tolerance = query.tolerance;
    map_pairs = query.maps ? 0 : query.limit_pairs;
}

std::string_view pair_class_name(PairClass kind) {
    switch (kind) {
    case PairClass::Separate:
        return "separate";
    case PairClass::Touch:
        return "touch";
    case PairClass::Coplanar:
        return "coplanar";
    case PairClass::Proper:
        return "proper";
    }
    return "unknown";
}

Result<ResultFiles> ResultFiles::open(const std::filesystem::path& dir,
                                      const std::vector<std::string>& formats,
                                      const ExportContext& context) {
    std::error_code error;
    std::filesystem::create_directories(dir, error);
    if (error) {
        return Error{ErrorCode::Io, dir.string() + ": " + error.message()};
    }
    ResultFiles files(dir, context);
    files.formats_ = formats;
    for (const std::string& format : formats) {
        auto writer = make_writer(format, context, dir);
        if (!writer) {
            return writer.error();
        }
        files.writers_.push_back(std::move(writer.value()));
    }
    return files;
}

Status ResultFiles::add(const ScenarioResult& result) {
    for (const auto& writer : writers_) {
        if (Status added = writer->add(result); !added) {
            return added;
        }
    }
    return Done{};
}

Status ResultFiles::finish(const std::optional<ContactMap>& map) {
    for (const auto& writer : writers_) {
        if (Status finished = writer->finish(); !finished) {
            return finished;
        }
    }
    return map ? write_map_files(*map, dir_, formats_, context_) : Status(Done{});
}

Status write_summary(const std::filesystem::path& dir,
                     const ExportContext& context,
                     const RunReport& report) {
    auto file = OutputFile::create(dir / "summary.json");
    if (!file) {
        return file.error();
    }
    if (Status written = file.value().write(summary_json(context, report) + "\n"); !written) {
        return written;
    }
    return file.value().commit();
}

} // namespace cd
