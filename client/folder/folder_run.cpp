#include "client/folder/folder_run.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/shell_word.hpp"
#include "client/job/job_text.hpp"
#include "client/job/submission.hpp"
#include "client/poses/label_file.hpp"
#include "client/remote/mesh_cache.hpp"
#include "common/core/build_info.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/wall_clock.hpp"
#include "common/core/version.hpp"
#include "common/core/words.hpp"
#include "common/job/poses/poses_hash.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <variant>

namespace cd {

namespace {

namespace fs = std::filesystem;

/// The fewest bytes of a scenario in a file: one pose as a quaternion with a translation.
constexpr std::uint64_t scenario_bytes = 64;

ManifestPoses poses_of(const PreparedJob& job) {
    ManifestPoses poses;
    poses.count = job.poses->count();
    const LabelColumns columns = job.labels.columns();
    poses.labels = {columns.ids != IdKind::None, columns.has_times, columns.has_end_times};
    if (job.grid) {
        poses.kind = PosesKind::Grid;
        poses.grid = job.grid;
    } else if (const auto* random = std::get_if<RandomPoses>(&job.spec.poses)) {
        poses.kind = PosesKind::Random;
        poses.random = *random;
    } else if (std::holds_alternative<ShotsSpec>(job.spec.poses)) {
        poses.kind = PosesKind::Shots;
    } else if (std::holds_alternative<CurveSpec>(job.spec.poses)) {
        poses.kind = PosesKind::Curve;
    } else if (const auto* file = std::get_if<PoseFileSpec>(&job.spec.poses)) {
        poses.file = absolute_path(file->path);
        poses.quat_order = file->quat_order;
        poses.of_both_bodies = file->of_both_bodies;
        poses.rigid_tolerance = file->rigid_tolerance;
        poses.unit = file->unit.empty() ? job.spec.unit : file->unit;
    }
    return poses;
}

Status move_file(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::create_directories(to.parent_path(), error);
    fs::rename(from, to, error);
    return error ? Status(Error{ErrorCode::Io, to.string() + ": " + error.message()})
                 : Status(Done{});
}

} // namespace

Result<RunManifest> manifest_of(const PreparedJob& job) {
    RunManifest manifest;
    manifest.origin.program = "cdctl " + std::string(version);
    manifest.origin.commit = build_commit();
    manifest.name = job.spec.name;
    manifest.unit = job.spec.unit;
    JobSpec spec = job.spec;
    make_paths_absolute(spec);
    spec.output.dir = "."; // The folder that holds run.json.
    manifest.job = job_text(spec);
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        ManifestBody body{body_of(job, i)};
        body.file = absolute_path(body.file);
        for (const Part& part : job.meshes[i]->parts()) {
            body.parts.push_back(part.name);
        }
        manifest.bodies.push_back(std::move(body));
    }
    manifest.query = job.query;
    manifest.poses = poses_of(job);
    if (job.scene) {
        manifest.scene = ManifestScene{job.scene->head.hash, job.scene->steps->steps()};
    }
    manifest.formats = job.spec.output.formats;
    if (manifest.poses.kind != PosesKind::Random) {
        const auto hash = CD_TRY(hash_of(*job.poses, &InterruptGuard::has_come));
        manifest.poses.hash = hash;
    }
    return manifest;
}

std::uint64_t bytes_beside_poses(const PreparedJob& job) {
    const auto bytes = [](const Mesh& mesh) {
        return mesh.vertices().size() * sizeof(Vec3) + mesh.triangles().size() * sizeof(Triangle);
    };
    std::uint64_t sum = label_bytes(job.labels);
    std::set<Sha256> known;
    for (const auto& mesh : job.meshes) {
        sum += known.insert(mesh->hash()).second ? bytes(*mesh) : 0;
    }
    return sum;
}

std::uint64_t input_bytes(const PreparedJob& job) {
    return bytes_beside_poses(job) + (job.grid ? 0 : job.poses->count() * scenario_bytes);
}

std::string own_command_line() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    while (!text.empty() && text.back() == '\0') {
        text.pop_back();
    }
    std::string line;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\0', begin), text.size());
        line += (begin == 0 ? "" : " ") + shell_word(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return line;
}

Result<FolderRun> FolderRun::begin(PreparedJob& job, FolderRunOptions options) {
    auto manifest = CD_TRY(manifest_of(job));
    manifest.origin.command = std::move(options.command);
    manifest.where = std::move(options.where);
    manifest.origin.started = options.started.empty() ? iso_time(unix_seconds()) : options.started;
    manifest.origin.ended = std::move(options.ended);
    manifest.outcome.reused = std::move(options.reused);
    auto folder = CD_TRY(RunFolder::open(job.spec.output.dir, manifest, options.folder));
    if (folder.unfinished()) {
        manifest.origin.started = folder.unfinished()->origin.started;
    }
    FolderRun run(std::move(folder), std::move(manifest), job);
    run.maps_from_master_ = options.maps_from_master;
    run.inputs_bytes_max_ = options.inputs_bytes_max;
    run.wants_inputs_ = options.keep_inputs;
    if (!run.is_complete()) {
        CD_TRY(run.open_files(job));
    }
    return run;
}

Status FolderRun::open_files(PreparedJob& job) {
    const bool sums_map = job_->query.maps && !maps_from_master_;
    recorder_.emplace(CD_TRY(RunRecorder::open(
        folder_.part(), sums_map ? body_part_runs(*job_->meshes[0], *job_->meshes[1]) : nullptr)));
    keeps_inputs_ = wants_inputs_ && input_bytes(job) <= inputs_bytes_max_;
    if (job.grid) {
        return Done{};
    }
    const PoseRecorderOptions options{
        !manifest_.poses.hash, keeps_inputs_ ? inputs_bytes_max_ - bytes_beside_poses(job) : 0};
    auto poses =
        CD_TRY(PoseRecorder::open(std::move(job.poses), folder_.part() / "scenarios", options));
    poses_ = poses.get();
    job.poses = std::move(poses);
    return Done{};
}

Result<ResultMerger> FolderRun::done() const {
    ResultMerger merger = merger_of(*job_);
    const auto records = CD_TRY(RecordFile::open_unfinished(folder_.part() / "records"));
    CD_TRY(records.for_each([&](const RecordView& record) -> Status {
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        const auto added = merger.add(record.result, digest_of_record(record.bytes));
        // Only a local run can be resumed: it writes its results in the order of their indices.
        if (added != ResultMerger::Outcome::Added ||
            merger.summary().merged() != record.result.index + 1) {
            return Error{ErrorCode::Io,
                         (folder_.part() / "records").string() + " cannot be resumed; add --fresh"};
        }
        return Done{};
    }));
    return merger;
}

Status FolderRun::keep_inputs() const {
    const fs::path inputs = folder_.out() / "inputs";
    std::error_code error;
    fs::create_directories(inputs / "meshes", error);
    std::set<Sha256> kept;
    for (const auto& mesh : job_->meshes) {
        if (kept.insert(mesh->hash()).second) {
            CD_TRY(write_mesh_file(mesh_file_path(inputs / "meshes", mesh->hash()), *mesh));
        }
    }
    if (!job_->labels.is_empty()) {
        CD_TRY(write_labels(inputs / "ids", job_->labels));
    }
    return poses_ == nullptr ? Status(Done{})
                             : move_file(folder_.part() / "scenarios", inputs / "scenarios");
}

Status FolderRun::finish_inputs() {
    if (poses_ != nullptr) {
        const auto hash = CD_TRY(poses_->finish(&InterruptGuard::has_come));
        manifest_.poses.hash = hash ? hash : manifest_.poses.hash;
        keeps_inputs_ = keeps_inputs_ && poses_->keeps();
    }
    return keeps_inputs_ ? keep_inputs() : Status(Done{});
}

Result<std::optional<ContactMap>>
FolderRun::finish_maps(const std::optional<ContactMap>& fetched) const {
    if (!job_->query.maps || (maps_from_master_ && !fetched)) {
        return std::optional<ContactMap>();
    }
    const fs::path path = folder_.part() / "maps";
    if (fetched) {
        CD_TRY(write_maps(path, *fetched, manifest_.poses.count));
    }
    std::optional<ContactMap> map = CD_TRY(read_maps(path));
    CD_TRY(move_file(path, folder_.out() / "maps"));
    return map;
}

Status FolderRun::finish(RunReport& report,
                         const std::string& output,
                         const std::optional<ContactMap>& fetched_map) {
    std::error_code error;
    fs::remove_all(folder_.out(), error);
    fs::create_directories(folder_.out(), error);
    CD_TRY(recorder_->finish());
    if (job_->scene) {
        const Bytes steps = pack_steps(*job_->scene->steps);
        CD_TRY(write_file(folder_.out() / "steps",
                          {reinterpret_cast<const char*>(steps.data()), steps.size()}));
    }
    report.map = CD_TRY(finish_maps(fetched_map));
    const ExportContext context = export_context(*job_);
    const auto records = CD_TRY(RecordFile::open(folder_.part() / "records"));
    SinkOptions options{folder_.out(), manifest_.formats, output};
    options.learn = job_->spec.scene ? job_->spec.scene->rules.learn : std::nullopt;
    auto sink = CD_TRY(ResultSink::open(std::move(options), context));
    CD_TRY(records.for_each([&](const RecordView& record) { return sink.add(record.result); }));
    if (!job_->query.maps && job_->query.level >= Level::Pairs) {
        report.map = sink.map();
    }
    CD_TRY(sink.finish(report.map));
    report.findings = sink.findings();
    CD_TRY(finish_inputs());
    report.folder.inputs_are_too_large = wants_inputs_ && !keeps_inputs_;
    CD_TRY(write_summary(folder_.out(), context, report));
    manifest_.origin.ended =
        manifest_.origin.ended.empty() ? iso_time(unix_seconds()) : manifest_.origin.ended;
    manifest_.outcome.answered = records.count();
    manifest_.outcome.digest = report.digest;
    manifest_.outcome.map_digest =
        report.map ? std::optional(digest_of(*report.map)) : std::optional<Sha256>();
    report.folder.summary_file = (folder_.dir() / "summary.json").string();
    const Status committed = folder_.commit(manifest_);
    is_finished_ = committed.has_value();
    return committed;
}

void FolderRun::drop_unfinished() {
    if (!is_finished_) {
        folder_.clean();
    }
}

} // namespace cd
