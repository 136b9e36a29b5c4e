#include "client/view/folder_source.hpp"

#include <filesystem>
#include <utility>

namespace cd {

namespace {

Error no_cluster() {
    return {ErrorCode::NotFound, "this is a results folder, not a cluster"};
}

} // namespace

FolderSource::FolderSource(asio::any_io_executor executor,
                           std::unique_ptr<ViewedRun> run,
                           StopCheck stop)
    : executor_(std::move(executor)),
      run_(std::move(run)),
      origin_(folder_origin(*run_)),
      stop_([is_closed = is_closed_, stop = std::move(stop)] { return *is_closed || stop(); }),
      runs_(executor_, runner_) {}

FolderSource::~FolderSource() {
    *is_closed_ = true;
}

template <class T, class Read>
void FolderSource::answer(const std::string& id, Take<T> take, Read read) {
    if (id != origin_.job) {
        return take(Error{ErrorCode::NotFound, "a folder has one job, '" + origin_.job + "'"});
    }
    reader_.post([executor = executor_, take = std::move(take), read = std::move(read)]() mutable {
        asio::post(executor, [take = std::move(take), found = Result<T>(read())]() mutable {
            take(std::move(found));
        });
    });
}

void FolderSource::cluster(Take<ClusterView> take) {
    take(no_cluster());
}

void FolderSource::history(Take<std::vector<HistorySample>> take) {
    take(no_cluster());
}

void FolderSource::jobs(Take<std::vector<JobRow>> take) {
    answer(origin_.job, std::move(take), [this] { return std::vector{run_->row(origin_.job)}; });
}

void FolderSource::job(const std::string& id, Take<JobView> take) {
    answer(id, std::move(take), [this] { return run_->view(origin_.job); });
}

void FolderSource::progress(const std::string& id, Take<JobRow> take) {
    answer(id, std::move(take), [this] { return Result(run_->row(origin_.job)); });
}

void FolderSource::classes(const std::string& id,
                           const ScenarioChoice& choice,
                           Take<std::vector<std::uint8_t>> take) {
    answer(id, std::move(take), [this, choice] { return run_->classes(choice); });
}

void FolderSource::counts(const std::string& id,
                          const ScenarioChoice& choice,
                          Take<std::vector<std::uint32_t>> take) {
    answer(id, std::move(take), [this, choice] { return run_->counts(choice); });
}

void FolderSource::distances(const std::string& id,
                             const ScenarioChoice& choice,
                             Take<std::vector<double>> take) {
    answer(id, std::move(take), [this, choice] { return run_->distances(choice); });
}

void FolderSource::poses(const std::string& id, const ScenarioChoice& choice, Take<PoseRows> take) {
    answer(id, std::move(take), [this, choice] { return run_->poses(choice); });
}

void FolderSource::keys(const std::string& id,
                        const ScenarioChoice& choice,
                        Take<std::vector<MotionKeys>> take) {
    answer(id, std::move(take), [this, choice] { return run_->keys(choice); });
}

void FolderSource::bodies(const std::string& id,
                          const ScenarioChoice& choice,
                          Take<std::vector<ScenePlace>> take) {
    answer(id, std::move(take), [this, choice] { return run_->places(choice); });
}

void FolderSource::steps(const std::string& id,
                         const ScenarioChoice& choice,
                         Take<std::vector<StepRow>> take) {
    answer(id, std::move(take), [this, choice] { return run_->steps(choice); });
}

void FolderSource::map(const std::string& id,
                       std::uint64_t body,
                       Take<std::vector<TriangleContacts>> take) {
    answer(id, std::move(take), [this, body] { return run_->map(body); });
}

void FolderSource::parts(const std::string& id,
                         std::uint64_t body,
                         Take<std::shared_ptr<const NamedParts>> take) {
    answer(id, std::move(take), [this, body] { return run_->parts(body); });
}

void FolderSource::closed_parts(const std::string& id,
                                std::uint64_t body,
                                Take<std::vector<bool>> take) {
    answer(id, std::move(take), [this, body] { return run_->closed_parts(body); });
}

void FolderSource::scenario(const std::string& id,
                            std::uint64_t number,
                            Take<std::shared_ptr<const ScenarioView>> take) {
    if (id != origin_.job) {
        return answer(id, std::move(take), [] { return no_cluster(); });
    }
    runs_.ask(
        {id, number}, [this, number] { return run_->scenario(number, stop_); }, std::move(take));
}

void FolderSource::next(const std::string& id, const NextContact& wanted, Take<NextFound> take) {
    answer(id, std::move(take), [this, wanted] { return run_->next(wanted); });
}

void FolderSource::mesh(const Sha256& mesh, Take<std::shared_ptr<HttpBody>> take) {
    answer(origin_.job, std::move(take), [this, mesh] { return mesh_body(mesh); });
}

Result<std::shared_ptr<HttpBody>> FolderSource::mesh_body(const Sha256& mesh) {
    const auto known = run_->mesh(mesh);
    if (known == nullptr) {
        return Error{ErrorCode::NotFound, "the run has no such mesh"};
    }
    auto file = DiskFile::open(run_->mesh_path(mesh));
    const auto size = file ? file.value().size() : Result<std::uint64_t>(file.error());
    if (!size) { // The folder keeps no inputs.
        return make_memory_body(known->canonical_bytes());
    }
    return make_file_body(std::move(file.value()), size.value(), reader_, executor_);
}

} // namespace cd
