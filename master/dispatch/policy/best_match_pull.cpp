#include "master/dispatch/policy/best_match_pull.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cd {

bool BestMatchPull::may_take(const WorkerProxy& proxy, const DispatchJob& job) const {
    return proxy.takes_work() && &proxy != context().reserved() &&
           proxy.has_room_for_task(job.id, job.options);
}

bool BestMatchPull::can_pull(const WorkerProxy& proxy, const DispatchJob& job) const {
    if (job.waiting.empty() || !may_take(proxy, job)) {
        return false;
    }
    return job.waiting.size() >= job.options.q ||
           (context().queue.input_rests(job) && proxy.would_run_dry(job.options));
}

std::vector<std::size_t> BestMatchPull::pulled(const WorkerProxy& proxy,
                                               const DispatchJob& job) const {
    std::vector<std::uint64_t> scores;
    scores.reserve(job.waiting.size());
    for (const std::uint64_t position : job.waiting) {
        scores.push_back(score(proxy, job, position));
    }
    std::vector<std::size_t> taken = most_similar(scores, job.options.q);
    // Paper, 6.4.3: a task ends as soon as it exceeds V kB.
    std::uint64_t bytes = 0;
    const auto end = std::ranges::find_if(taken, [&](std::size_t index) {
        const bool is_over = bytes > std::uint64_t{job.options.v_kb} * 1000;
        bytes += job.at(job.waiting[index]).weight.bytes;
        return is_over;
    });
    taken.erase(end, taken.end());
    return taken;
}

std::uint64_t BestMatchPull::score(const WorkerProxy& proxy,
                                   const DispatchJob& job,
                                   std::uint64_t position) const {
    return held_triangles(context().plan, proxy.slot(), job.at(position).roots);
}

std::vector<std::size_t> BestMatchPull::most_similar(std::span<const std::uint64_t> scores,
                                                     std::size_t count) {
    std::vector<std::size_t> indices(scores.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    count = std::min(count, indices.size());
    const auto end = indices.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(indices.begin(), end, indices.end(), [&](std::size_t one, std::size_t other) {
        return std::tuple(scores[other], one) < std::tuple(scores[one], other);
    });
    indices.erase(end, indices.end());
    std::sort(indices.begin(), indices.end());
    return indices;
}

} // namespace cd
