#include "worker/execution/task_results.hpp"

#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"

#include <utility>

namespace cd {

void TaskResults::add(const FinishedScenarios& finished) {
    sum_.records.insert(sum_.records.end(), finished.records.begin(), finished.records.end());
    sum_.count += finished.count;
    sum_.statistics += finished.statistics;
    sum_.seconds += finished.seconds;
    map_.add(finished.map);
    if (finished.count != 0) {
        seconds_per_scenario_ = finished.seconds / finished.count;
    }
}

std::optional<Results> TaskResults::take(TaskId task, const WorkerJob& job, bool is_within_host) {
    if (sum_.count == 0) {
        return std::nullopt;
    }
    FinishedScenarios finished = std::exchange(sum_, {});
    sum_.records.reserve(finished.records.size()); // The next results are about as long.
    Results results;
    results.task = task;
    results.job = job.id;
    results.count = finished.count;
    SentRecords records = records_to_send(std::move(finished.records), is_within_host);
    results.records = std::move(records.bytes);
    results.are_packed = records.are_packed;
    results.statistics = finished.statistics;
    results.compute_seconds = finished.seconds;
    if (job.query.maps || job.parts != nullptr) {
        results.map = pack_map(map_.take());
    }
    return results;
}

} // namespace cd
