#include "client/export/result_sink.hpp"

#include "client/export/shots/shot_writers.hpp"
#include "client/formats/array_file.hpp"
#include "client/spec/job_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace cd {

namespace {

/// Once the partial sum `MapSum::waiting` has this many bytes, it is added to the total.
constexpr std::uint64_t waiting_bytes_max = 1u << 20;

/// Returns the file name of a format that has a single file.
std::string file_of(std::string_view format) {
    return format == "csv" ? "scenarios.csv" : format == "text" ? "results.txt" : "results.jsonl";
}

std::unique_ptr<ResultWriter>
make_row_writer(std::string_view format, const ExportContext& context, OutputFile file) {
    return format == "csv"    ? make_scenarios_csv_writer(context, std::move(file))
           : format == "json" ? make_json_writer(context, std::move(file))
                              : make_text_writer(context, std::move(file));
}

Result<std::unique_ptr<ResultWriter>> make_writer(const std::string& format,
                                                  const ExportContext& context,
                                                  const std::filesystem::path& dir) {
    if (format == "csv-pairs") {
        return make_pairs_csv_writer(context, dir);
    }
    if (is_array_format(format)) {
        return make_array_writer(format, context, dir);
    }
    if (format == "vtp") {
        return make_vtp_writer(context, dir);
    }
    CD_TRY(check_format(format));
    auto file = CD_TRY(OutputFile::create(dir / file_of(format)));
    return make_row_writer(format, context, std::move(file));
}

std::vector<std::shared_ptr<const Mesh>> meshes_of(const ExportContext& context) {
    std::vector<std::shared_ptr<const Mesh>> meshes;
    for (const ExportBody& body : context.bodies) {
        meshes.push_back(body.mesh);
    }
    return meshes;
}

} // namespace

ResultSink::ResultSink(SinkOptions options, const ExportContext& context)
    : options_(std::move(options)),
      context_(context),
      groups_(meshes_of(context), part_kind(context.level)),
      map_{ContactMapSum(context.listed.maps
                             ? body_part_runs(*context.bodies[0].mesh, *context.bodies[1].mesh)
                             : nullptr),
           {}} {}

Result<ResultSink> ResultSink::open(SinkOptions options, const ExportContext& context) {
    ResultSink sink(std::move(options), context);
    const SinkOptions& to = sink.options_;
    if (!to.dir.empty()) {
        CD_TRY(make_directories(to.dir));
        CD_TRY(check_map_formats(to.formats, context.map_use()));
        CD_TRY(sink.add_writers());
    }
    if (context.has_hits()) {
        CD_TRY(sink.add_shot_writers());
    }
    if (context.steps) {
        const bool writes = !to.dir.empty() && sink.has_format("csv");
        auto log = CD_TRY(
            SceneLog::open(context, writes ? std::optional(to.dir) : std::nullopt, to.learn));
        sink.scene_.emplace(std::move(log));
    }
    if (sink.uses_stdout()) {
        sink.writers_.push_back(make_row_writer(to.output, context, OutputFile::standard_output()));
    }
    return sink;
}

Status ResultSink::add_writers() {
    for (const std::string& format : options_.formats) {
        // The files of a GLB are made of the map alone; hits of lines have files of their own.
        if (format != "glb" && !(format == "csv-pairs" && context_.has_hits())) {
            writers_.push_back(CD_TRY(make_writer(format, context_, options_.dir)));
        }
    }
    return Done{};
}

Status ResultSink::add_shot_writers() {
    const auto job = std::make_shared<const ShotJob>(context_);
    if (job->knows_ends()) {
        shots_.emplace(job, context_.unit);
    }
    for (const std::string_view format : array_formats) {
        if (has_format(format)) {
            writers_.push_back(make_shots_array_writer(format, context_, options_.dir));
        }
    }
    if (has_format("csv-pairs")) {
        writers_.push_back(CD_TRY(make_shotlines_writer(job, options_.dir)));
    }
    return Done{};
}

std::vector<TouchedPart> ResultSink::most_touched() const {
    std::vector<TouchedPart> touched = groups_.most_touched();
    for (TouchedPart& part : touched) {
        part.part = context_.steps ? context_.bodies[part.body].name + "/" + part.part : part.part;
    }
    return touched;
}

RunFindings ResultSink::findings() const {
    return {most_touched(),
            least_,
            scene_ ? std::optional(scene_->findings()) : std::nullopt,
            shots_ ? shots_->parts() : std::vector<ShotPart>(),
            first_event_};
}

void ResultSink::MapSum::add_waiting_if_large() {
    if (waiting.bytes() >= waiting_bytes_max) {
        total.add(waiting.take());
    }
}

ContactMap ResultSink::MapSum::map() {
    total.add(waiting.take());
    return total.map();
}

void ResultSink::add_to_maps(const ScenarioResult& result, std::span<const ContactPair> found) {
    const std::vector<ContactPair> crossings = crossings_of(result);
    const std::span<const ContactPair> listed = context_.has_hits() ? crossings : result.pairs;
    map_.waiting.add(result, found.empty() ? listed : found);
    map_.add_waiting_if_large();
    if (context_.tells_contacts()) {
        std::vector<ContactPair> contacts = result.pairs;
        std::erase_if(contacts, [](const ContactPair& p) { return p.kind == PairClass::Near; });
        contacts_.waiting.add(contacts);
        contacts_.add_waiting_if_large();
    }
}

Status ResultSink::add(const ScenarioResult& result, std::span<const ContactPair> found) {
    if (context_.stop && context_.stop()) {
        return interrupted();
    }
    const std::uint32_t body = std::max(result.body_a, result.body_b);
    const std::size_t bodies = context_.bodies.size();
    if (body >= bodies) {
        return bad_input("the result of scenario " + std::to_string(result.index) + " is of body " +
                         std::to_string(body) + ", and the job has " + std::to_string(bodies));
    }
    groups_.add(result);
    note_least(result, context_.unit, least_);
    keep_first(context_.times.event(result), first_event_);
    tested_ += result.kind == ScenarioClass::Failed ? 0 : 1;
    if (shots_) {
        CD_TRY(shots_->add(result));
    }
    if (context_.map_use().has_map()) {
        add_to_maps(result, found);
    }
    for (const auto& writer : writers_) {
        CD_TRY(writer->add(result));
    }
    if (scene_) {
        CD_TRY(scene_->add(result));
    }
    return Done{};
}

std::optional<ContactMap> ResultSink::map() {
    if (!context_.map_use().has_map()) {
        return std::nullopt;
    }
    return map_.map();
}

bool ResultSink::has_format(std::string_view format) const {
    return std::ranges::find(options_.formats, format) != options_.formats.end();
}

Status ResultSink::write_map(const ContactMap& map) {
    ExportMap exported{map};
    if (context_.tells_contacts()) {
        exported.contacts = contacts_.map();
    }
    CD_TRY(write_map_files(exported, options_.dir, options_.formats, context_));
    if (has_format("vtp")) {
        CD_TRY(write_vtp_bodies(exported, tested_, options_.dir, context_));
    }
    return has_format("glb") ? write_glb_bodies(map, tested_, options_.dir, context_)
                             : Status(Done{});
}

GroupsOrigin ResultSink::groups_origin() const {
    GroupsOrigin origin{{},
                        tested_,
                        context_.listed.limit_pairs,
                        groups_.left_out(),
                        context_.clearance.has_value()};
    for (const ExportBody& body : context_.bodies) {
        origin.bodies.push_back(body.name);
    }
    return origin;
}

Status ResultSink::finish(const std::optional<ContactMap>& map) {
    for (const auto& writer : writers_) {
        CD_TRY(writer->finish());
    }
    if (shots_) {
        shots_->finish();
    }
    if (scene_) {
        CD_TRY(scene_->finish());
    }
    const bool has_sums = context_.level == Level::Count && map.has_value();
    if (has_sums) {
        CD_TRY(groups_.add(map->parts));
    }
    if (options_.dir.empty()) {
        return Done{};
    }
    if (has_format("csv") && (has_sums || context_.level >= Level::Pairs)) {
        CD_TRY(write_groups_csv(options_.dir / "groups.csv", rows_of(groups_), groups_origin()));
    }
    return map ? write_map(*map) : Status(Done{});
}

Status print_summary(const RunReport& report, bool stdout_is_used, bool quiet, bool statistics) {
    if (stdout_is_used) {
        const std::string text = quiet ? warnings_text(report)
                                       : summary_text(report, {colours_wanted(stderr), statistics});
        std::fputs(text.c_str(), stderr);
        return Done{};
    }
    OutputFile out = OutputFile::standard_output();
    CD_TRY(out.write(summary_text(report, {colours_wanted(stdout), statistics})));
    return out.commit();
}

} // namespace cd
