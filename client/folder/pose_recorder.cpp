#include "client/folder/pose_recorder.hpp"

#include "common/core/errors.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_at_once = 4096;

} // namespace

Result<std::unique_ptr<PoseRecorder>> PoseRecorder::open(std::unique_ptr<PoseSource> source,
                                                         const std::filesystem::path& file,
                                                         PoseRecorderOptions options) {
    std::unique_ptr<PoseRecorder> recorder(new PoseRecorder(std::move(source), file, options));
    const Status opened = recorder->open_file();
    return opened ? Result<std::unique_ptr<PoseRecorder>>(std::move(recorder)) : opened.error();
}

Status PoseRecorder::open_file() {
    if (bytes_max_ == 0) {
        drop_file();
        return Done{};
    }
    std::error_code error;
    const bool resumes = std::filesystem::exists(file_, error);
    writer_.emplace(
        CD_TRY(resumes ? ScenarioWriter::resume(file_) : ScenarioWriter::create(file_)));
    next_ = writer_->written();
    if (!hash_ || next_ == 0) {
        return Done{};
    }
    auto before = open_unfinished_scenario_file(file_);
    for (std::uint64_t first = 0; before && first < next_; first += scenarios_at_once) {
        const auto scenarios =
            CD_TRY(before.value()->read(first, std::min(scenarios_at_once, next_ - first)));
        hash_->add(scenarios);
    }
    return before ? Status(Done{}) : before.error();
}

void PoseRecorder::drop_file() {
    writer_.reset();
    std::error_code error;
    std::filesystem::remove(file_, error);
}

Status PoseRecorder::add(std::span<const Scenario> news) {
    next_ += news.size();
    if (hash_) {
        hash_->add(news);
    }
    if (!writer_) {
        return Done{};
    }
    CD_TRY(writer_->add(news));
    if (writer_->bytes() > bytes_max_) {
        drop_file();
    }
    return Done{};
}

Result<std::vector<Scenario>> PoseRecorder::read(std::uint64_t first, std::uint64_t count) {
    auto scenarios = CD_TRY(source_->read(first, count));
    const std::lock_guard lock(mutex_);
    if (first <= next_ && next_ < first + count) {
        const auto news = std::span<const Scenario>(scenarios).subspan(next_ - first);
        CD_TRY(add(news));
    }
    return scenarios;
}

Result<std::optional<Sha256>> PoseRecorder::finish(const StopCheck& stop) {
    while ((writer_ || hash_) && next_ < count()) {
        if (stop && stop()) {
            return interrupted();
        }
        CD_TRY(read(next_, std::min(scenarios_at_once, count() - next_)));
    }
    if (writer_) {
        CD_TRY(writer_->finish());
    }
    return hash_ ? std::optional(hash_->finish()) : std::optional<Sha256>();
}

} // namespace cd
