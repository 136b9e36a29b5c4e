#include "client/export/result_sink.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

namespace cd {

namespace {

/// The size in bytes at which the partial sum `waiting_` is added to the total `map_`.
constexpr std::uint64_t waiting_bytes_max = 1u << 20;

std::unique_ptr<ResultWriter> stdout_writer(const std::string& output,
                                            const ExportContext& context) {
    if (output == "json") {
        return make_json_writer(context, OutputFile::standard_output());
    }
    if (output == "csv") {
        return make_scenarios_csv_writer(context, OutputFile::standard_output());
    }
    return output == "records-text" ? make_text_writer(context, OutputFile::standard_output())
                                    : nullptr;
}

} // namespace

Result<ResultSink> ResultSink::open(const SinkOptions& options, const ExportContext& context) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const ExportBody& body : context.bodies) {
        meshes.push_back(body.mesh);
    }
    ResultSink sink(meshes, context.stop);
    if (!options.dir.empty()) {
        auto files = ResultFiles::open(options.dir, options.formats, context);
        if (!files) {
            return files.error();
        }
        sink.files_.emplace(std::move(files.value()));
    }
    sink.stdout_writer_ = stdout_writer(options.output, context);
    return sink;
}

Status ResultSink::add(const ScenarioResult& result, std::span<const ContactPair> found) {
    if (stop_ && stop_()) {
        return interrupted();
    }
    const std::uint32_t body = std::max(result.body_a, result.body_b);
    if (body >= body_count_) {
        return Error{ErrorCode::BadInput,
                     "the result of scenario " + std::to_string(result.index) + " is of body " +
                         std::to_string(body) + ", and the job has " + std::to_string(body_count_)};
    }
    tally_.add(result);
    waiting_.add(found.empty() ? std::span<const ContactPair>(result.pairs) : found);
    if (waiting_.bytes() >= waiting_bytes_max) {
        map_.add(waiting_.take());
    }
    if (files_) {
        if (Status added = files_->add(result); !added) {
            return added;
        }
    }
    return stdout_writer_ ? stdout_writer_->add(result) : Status(Done{});
}

ContactMap ResultSink::map() {
    map_.add(waiting_.take());
    return map_.map();
}

Status ResultSink::finish(const std::optional<ContactMap>& map) {
    if (files_) {
        if (Status finished = files_->finish(map); !finished) {
            return finished;
        }
    }
    return stdout_writer_ ? stdout_writer_->finish() : Status(Done{});
}

Status print_summary(const RunReport& report, bool stdout_is_used, bool quiet, bool statistics) {
    if (stdout_is_used) {
        const std::string text = quiet ? warnings_text(report)
                                       : summary_text(report, {colours_wanted(stderr), statistics});
        std::fputs(text.c_str(), stderr);
        return Done{};
    }
    OutputFile out = OutputFile::standard_output();
    const Status written = out.write(summary_text(report, {colours_wanted(stdout), statistics}));
    return written ? out.commit() : written;
}

} // namespace cd
