#include "client/export/shots/bundle_passages.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_at_once = 4096;

/// Sorts the passages of several bodies, each of which has its own in order.
void sort_passages(std::vector<BodyPassage>& passages) {
    std::ranges::stable_sort(passages, {}, [](const BodyPassage& passage) {
        return std::tuple(passage.way.line, passage.way.in.depth);
    });
}

void keep_first_of_lines(std::vector<BodyPassage>& passages) {
    const auto line = [](const BodyPassage& passage) { return passage.way.line; };
    passages.erase(std::ranges::unique(passages, {}, line).begin(), passages.end());
}

} // namespace

Result<std::optional<BundlePassages>> PassageGatherer::add(const ScenarioResult& result) {
    if (result.body_a >= job_->bodies() || result.body_b != job_->bodies()) {
        return Error{ErrorCode::BadFrame,
                     "the result of scenario " + std::to_string(result.index) +
                         " is not of a body and the lines"};
    }
    const std::uint64_t key = result.step.value_or(result.index);
    std::optional<BundlePassages> before;
    if (key_ != key) {
        before = finish();
        key_ = key;
        gathered_.bundle = key % (job_->steps() ? job_->views().bundles() : UINT64_MAX);
    }
    if (!result.hits.empty()) {
        const auto pose = CD_TRY(pose_of(result.index));
        add_passages(result, pose);
    }
    return before;
}

std::optional<BundlePassages> PassageGatherer::finish() {
    if (!key_) {
        return std::nullopt;
    }
    key_.reset();
    if (gathered_.bodies.size() > 1) {
        sort_passages(gathered_.passages);
    }
    if (job_->takes_first()) {
        keep_first_of_lines(gathered_.passages);
    }
    return std::exchange(gathered_, {});
}

Result<std::optional<Pose>> PassageGatherer::pose_of(std::uint64_t scenario) {
    if (job_->poses() == nullptr) {
        return std::optional<Pose>();
    }
    const bool is_in_window = !window_.empty() && scenario >= window_.front().index &&
                              scenario - window_.front().index < window_.size();
    if (!is_in_window) {
        const std::uint64_t left = job_->poses()->count() - scenario;
        window_ = CD_TRY(job_->poses()->read(scenario, std::min(scenarios_at_once, left)));
    }
    return std::optional(window_[scenario - window_.front().index].poses.a);
}

void PassageGatherer::add_passages(const ScenarioResult& result, const std::optional<Pose>& pose) {
    const auto place = static_cast<std::uint32_t>(gathered_.bodies.size());
    gathered_.bodies.push_back({result.body_a, result.index, pose});
    for (const Passage& passage : job_->finder(result.body_a).passages(result, pose)) {
        gathered_.passages.push_back({passage, place});
    }
}

} // namespace cd
