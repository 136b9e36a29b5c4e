#include "client/folder/folder_run.hpp"

#include "client/base/interrupt.hpp"
#include "client/base/words.hpp"
#include "client/folder/job_text.hpp"
#include "client/job/submission.hpp"
#include "client/poses/label_file.hpp"
#include "client/remote/mesh_cache.hpp"
#include "common/core/build_info.hpp"
#include "common/core/host/wall_clock.hpp"
#include "common/core/version.hpp"
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

/// The fewest bytes that a scenario takes in a file: one pose as a quaternion with a translation.
constexpr std::uint64_t scenario_bytes = 64;

std::string absolute_path(const fs::path& path) {
    std::error_code error;
    const fs::path whole = path == "-" ? path : fs::absolute(path, error).lexically_normal();
    return (error ? path : whole).string();
}

ManifestPoses poses_of(const PreparedJob& job) {
    ManifestPoses poses;
    poses.count = job.poses->count();
    poses.has_ids = job.labels.columns().ids != IdKind::None;
    poses.has_times = job.labels.columns().has_times;
    if (job.grid) {
        poses.kind = PosesKind::Grid;
        poses.grid = job.grid;
    } else if (const auto* random = std::get_if<RandomPoses>(&job.spec.poses)) {
        poses.kind = PosesKind::Random;
        poses.random = *random;
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
    spec.output.dir = "."; // The folder of run.json.
    manifest.job = job_text(spec);
    for (std::size_t i = 0; i < job.meshes.size(); ++i) {
        ManifestBody body{body_of(spec, i, job.meshes[i]->hash())};
        for (const Part& part : job.meshes[i]->parts()) {
            body.parts.push_back(part.name);
        }
        manifest.bodies.push_back(std::move(body));
    }
    manifest.query = job.query;
    manifest.poses = poses_of(job);
    manifest.formats = job.spec.output.formats;
    if (manifest.poses.kind != PosesKind::Random) {
        const auto hash = hash_of(*job.poses, &InterruptGuard::has_come);
        if (!hash) {
            return hash.error();
        }
        manifest.poses.hash = hash.value();
    }
    return manifest;
}

std::uint64_t bytes_beside_poses(const PreparedJob& job) {
    const auto bytes = [](const Mesh& mesh) {
        return mesh.vertices().size() * sizeof(Vec3) + mesh.triangles().size() * sizeof(Triangle);
    };
    return label_bytes(job.labels) + bytes(*job.meshes[0]) +
           (job.meshes[0]->hash() == job.meshes[1]->hash() ? 0 : bytes(*job.meshes[1]));
}

std::uint64_t input_bytes(const PreparedJob& job) {
    return bytes_beside_poses(job) + (job.grid ? 0 : job.poses->count() * scenario_bytes);
}

void make_paths_absolute(JobSpec& spec) {
    for (BodySpec& body : spec.bodies) {
        body.path = absolute_path(body.path);
    }
    if (auto* file = std::get_if<PoseFileSpec>(&spec.poses)) {
        file->path = absolute_path(file->path);
    }
}

std::string own_command_line() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    while (!text.empty() && text.back() == '\0') {
        text.pop_back();
    }
    std::ranges::replace(text, '\0', ' ');
    return text;
}

Result<FolderRun> FolderRun::begin(PreparedJob& job, FolderRunOptions options) {
    auto manifest = manifest_of(job);
    if (!manifest) {
        return manifest.error();
    }
    manifest.value().origin.command = std::move(options.command);
    manifest.value().where = std::move(options.where);
    manifest.value().origin.started =
        options.started.empty() ? iso_time(unix_seconds()) : options.started;
    manifest.value().origin.ended = std::move(options.ended);
    auto folder = RunFolder::open(job.spec.output.dir, manifest.value(), options.folder);
    if (!folder) {
        return folder.error();
    }
    FolderRun run(std::move(folder.value()), std::move(manifest.value()), job);
    if (run.folder_.unfinished()) {
        run.manifest_.origin.started = run.folder_.unfinished()->origin.started;
    }
    run.maps_from_master_ = options.maps_from_master;
    run.inputs_bytes_max_ = options.inputs_bytes_max;
    run.wants_inputs_ = options.keep_inputs;
    if (!run.is_complete()) {
        if (Status opened = run.open_files(job); !opened) {
            return opened.error();
        }
    }
    return run;
}

Status FolderRun::open_files(PreparedJob& job) {
    auto recorder = RunRecorder::open(folder_.part(), job_->query.maps && !maps_from_master_);
    if (!recorder) {
        return recorder.error();
    }
    recorder_.emplace(std::move(recorder.value()));
    keeps_inputs_ = wants_inputs_ && input_bytes(job) <= inputs_bytes_max_;
    if (job.grid) {
        return Done{};
    }
    PoseRecorderOptions options;
    options.hashes = !manifest_.poses.hash;
    options.bytes_max = keeps_inputs_ ? inputs_bytes_max_ - bytes_beside_poses(job) : 0;
    auto poses = PoseRecorder::open(std::move(job.poses), folder_.part() / "scenarios", options);
    if (!poses) {
        return poses.error();
    }
    poses_ = poses.value().get();
    job.poses = std::move(poses.value());
    return Done{};
}

Result<ResultMerger> FolderRun::done() const {
    ResultMerger merger(manifest_.poses.count);
    const auto records = RecordFile::open_unfinished(folder_.part() / "records");
    if (!records) {
        return records.error();
    }
    const Status read = records.value().for_each([&](const KeptRecord& record) -> Status {
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        const auto added = merger.add(record.result, sha256(record.bytes));
        // Only a local run, which writes its results in the order of their indices, can be resumed.
        return added == ResultMerger::Outcome::Added &&
                       merger.summary().merged() == record.result.index + 1
                   ? Status(Done{})
                   : Status(Error{ErrorCode::Io,
                                  (folder_.part() / "records").string() +
                                      " cannot be resumed; add --fresh"});
    });
    return read ? Result<ResultMerger>(std::move(merger)) : read.error();
}

Status FolderRun::keep_inputs() const {
    const fs::path inputs = folder_.out() / "inputs";
    std::error_code error;
    fs::create_directories(inputs / "meshes", error);
    for (std::size_t i = 0; i < job_->meshes.size(); ++i) {
        if (i > 0 && job_->meshes[i]->hash() == job_->meshes[0]->hash()) {
            continue;
        }
        const Mesh& mesh = *job_->meshes[i];
        const Status written =
            write_mesh_file(mesh_file_path(inputs / "meshes", mesh.hash()), mesh);
        if (!written) {
            return written;
        }
    }
    if (!job_->labels.is_empty()) {
        if (Status written = write_labels(inputs / "ids", job_->labels); !written) {
            return written;
        }
    }
    return poses_ == nullptr ? Status(Done{})
                             : move_file(folder_.part() / "scenarios", inputs / "scenarios");
}

Status FolderRun::finish_inputs() {
    if (poses_ != nullptr) {
        const auto hash = poses_->finish(&InterruptGuard::has_come);
        if (!hash) {
            return hash.error();
        }
        manifest_.poses.hash = hash.value() ? hash.value() : manifest_.poses.hash;
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
        if (Status written = write_maps(path, *fetched, manifest_.poses.count); !written) {
            return written.error();
        }
    }
    auto map = read_maps(path);
    if (!map) {
        return map.error();
    }
    if (Status moved = move_file(path, folder_.out() / "maps"); !moved) {
        return moved.error();
    }
    return std::optional(std::move(map.value()));
}

Status FolderRun::finish(RunReport& report,
                         const std::string& output,
                         const std::optional<ContactMap>& fetched_map) {
    std::error_code error;
    fs::remove_all(folder_.out(), error);
    fs::create_directories(folder_.out(), error);
    if (Status finished = recorder_->finish(); !finished) {
        return finished;
    }
    auto kept_map = finish_maps(fetched_map);
    if (!kept_map) {
        return kept_map.error();
    }
    const ExportContext context = export_context(*job_);
    const auto records = RecordFile::open(folder_.part() / "records");
    auto sink = ResultSink::open({folder_.out(), manifest_.formats, output}, context);
    if (!records || !sink) {
        return records ? sink.error() : records.error();
    }
    const Status exported = records.value().for_each(
        [&](const KeptRecord& record) { return sink.value().add(record.result); });
    if (!exported) {
        return exported;
    }
    report.map = std::move(kept_map.value());
    if (!job_->query.maps && job_->query.level >= Level::Pairs) {
        report.map = sink.value().map();
    }
    if (Status finished = sink.value().finish(report.map); !finished) {
        return finished;
    }
    report.most_touched = sink.value().tally().most_touched();
    if (Status kept = finish_inputs(); !kept) {
        return kept;
    }
    report.inputs_are_too_large = wants_inputs_ && !keeps_inputs_;
    if (Status written = write_summary(folder_.out(), context, report); !written) {
        return written;
    }
    manifest_.origin.ended =
        manifest_.origin.ended.empty() ? iso_time(unix_seconds()) : manifest_.origin.ended;
    manifest_.outcome.answered = records.value().count();
    manifest_.outcome.digest = report.digest;
    manifest_.outcome.map_digest =
        report.map ? std::optional(digest_of(*report.map)) : std::optional<Sha256>();
    report.summary_file = (folder_.dir() / "summary.json").string();
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
