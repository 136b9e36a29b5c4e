#include "master/results/parked_results.hpp"

#include <utility>

namespace cd {

namespace {

std::uint64_t bytes_of(const Results& message) {
    return sizeof(message) + message.records.size() + message.map.size();
}

} // namespace

void ParkedResults::park(IncomingResults late) {
    const Key key{late.message->job, late.author->worker, late.message->sequence};
    const auto [place, is_new] = late_.try_emplace(key, std::move(late));
    if (is_new) {
        count(place->second);
    } else {
        late.done(); // The message is parked already: it came over an earlier connection.
    }
}

bool ParkedResults::has_any(JobId job) const {
    const auto first = late_.lower_bound({job, WorkerId{}, 0});
    return first != late_.end() && std::get<JobId>(first->first) == job;
}

std::vector<IncomingResults> ParkedResults::take(JobId job) {
    std::vector<IncomingResults> all;
    while (has_any(job)) {
        const auto first = late_.lower_bound({job, WorkerId{}, 0});
        uncount(first->second);
        all.push_back(std::move(first->second));
        late_.erase(first);
    }
    return all;
}

void ParkedResults::forget(WorkerId worker) {
    std::erase_if(late_, [&](const auto& late) {
        const bool is_its = late.second.author->worker == worker;
        if (is_its) {
            uncount(late.second);
        }
        return is_its;
    });
}

void ParkedResults::count(IncomingResults& kept) {
    bytes_ += bytes_of(*kept.message);
    if (bytes_ <= bytes_max_) {
        std::exchange(kept.done, [] {})();
    }
}

void ParkedResults::uncount(const IncomingResults& kept) {
    bytes_ -= bytes_of(*kept.message);
}

} // namespace cd
