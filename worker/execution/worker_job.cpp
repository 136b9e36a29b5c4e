#include "worker/execution/worker_job.hpp"

#include <algorithm>
#include <utility>

namespace cd {

void DroppedScenarios::add(std::uint64_t scenario) {
    const std::lock_guard lock(mutex_);
    scenarios_.insert(scenario);
    any_.store(true);
}

bool DroppedScenarios::contains(std::uint64_t scenario) const {
    if (!any_.load(std::memory_order_relaxed)) {
        return false;
    }
    const std::lock_guard lock(mutex_);
    return scenarios_.contains(scenario);
}

namespace {

/// Returns the parts of a job's two bodies; null if the list is empty. Errors: BadFrame.
Result<std::shared_ptr<const BodyPartRuns>> parts_of(std::vector<std::vector<PartRun>> lists,
                                                     std::size_t bodies) {
    if (lists.empty()) {
        return std::shared_ptr<const BodyPartRuns>();
    }
    auto parts = std::make_shared<BodyPartRuns>();
    if (lists.size() != parts->size() || bodies != parts->size()) {
        return Error{ErrorCode::BadFrame, "parts of other than two bodies"};
    }
    for (std::size_t i = 0; i < lists.size(); ++i) {
        Result<PartRuns> runs = PartRuns::create(std::move(lists[i]));
        if (!runs) {
            return Error{ErrorCode::BadFrame, runs.error().detail};
        }
        (*parts)[i] = std::move(runs.value());
    }
    return std::shared_ptr<const BodyPartRuns>(std::move(parts));
}

/// Whether each body has a radius in a job of motions, and none has one in other jobs.
bool are_radii(const std::vector<double>& radii, const Query& query, std::size_t bodies) {
    const std::size_t expected = query.question == Question::Motion ? bodies : 0;
    return radii.size() == expected &&
           std::ranges::all_of(radii, [](double radius) { return radius >= 0; });
}

} // namespace

Result<std::shared_ptr<const WorkerJob>> make_worker_job(AddJob add, const SubtreeCache& cache) {
    const std::string name = "job " + std::to_string(add.job.value) + " ";
    if (add.trees.size() < 2) {
        return Error{ErrorCode::BadFrame,
                     name + "has " + std::to_string(add.trees.size()) + " bodies"};
    }
    for (const TreeId tree : add.trees) {
        if (cache.find(tree) == nullptr) {
            return Error{ErrorCode::BadFrame, name + "names a tree that is not here"};
        }
        if (cache.form_of(tree) != cache.form_of(add.trees[0])) {
            return Error{ErrorCode::BadFrame,
                         name + "has trees of forms that cannot be tested against each other"};
        }
    }
    auto parts = parts_of(std::move(add.parts), add.trees.size());
    if (!parts) {
        return Error{ErrorCode::BadFrame, name + "has " + parts.error().detail};
    }
    if (!are_radii(add.radii, add.query, add.trees.size())) {
        return Error{ErrorCode::BadFrame, name + "lacks the radius of a body, or has one too many"};
    }
    WorkerJob job{add.job,
                  std::move(add.trees),
                  std::move(add.query),
                  {},
                  std::move(parts.value()),
                  std::move(add.radii)};
    if (add.grid) {
        Result<Grid> grid = decode_grid(*add.grid);
        if (!grid) {
            return Error{ErrorCode::BadFrame, name + "has a bad grid: " + grid.error().detail};
        }
        job.grid = std::move(grid.value());
    }
    return std::make_shared<const WorkerJob>(std::move(job));
}

} // namespace cd
