#include "client/view/record_index.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "common/core/words.hpp"
#include "common/job/result/severity.hpp"
#include "web/server/page_source.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <mutex>
#include <utility>

namespace cd {

namespace {

constexpr double no_distance = std::numeric_limits<double>::quiet_NaN();

std::uint64_t& count_of_class(Summary& summary, ScenarioClass kind) {
    switch (kind) {
    case ScenarioClass::Separate:
        return summary.separate;
    case ScenarioClass::Touch:
        return summary.touch;
    case ScenarioClass::Cross:
        return summary.cross;
    case ScenarioClass::Inside:
        return summary.inside;
    case ScenarioClass::Contact:
        return summary.contact;
    case ScenarioClass::Undecided:
        return summary.undecided;
    case ScenarioClass::Near:
        return summary.near;
    case ScenarioClass::Failed:
        break;
    }
    return summary.failed;
}

void count(Summary& summary, const ScenarioResult& result) {
    ++count_of_class(summary, result.kind);
    summary.pairs += result.pair_count;
    summary.near_pairs += result.near_count;
    summary.surfaces_only += result.surfaces_only ? 1 : 0;
    summary.insides_skipped += result.insides_skipped ? 1 : 0;
    summary.cut += result.is_cut() ? 1 : 0;
}

/// The sums of all threads, and their first error.
struct Sums {
    std::mutex mutex;
    Status status = Done{};
    ContactMapTotal map;
};

} // namespace

Result<RecordIndex> RecordIndex::read(const RecordFile& records,
                                      std::uint64_t scenarios,
                                      ThreadPool& pool,
                                      const StopCheck& stop) {
    if (scenarios > limits::page_index_scenarios_max) {
        return Error{ErrorCode::TooLarge,
                     "the run has " + counted(scenarios, "scenario") +
                         "; the page shows runs of at most " +
                         grouped(limits::page_index_scenarios_max)};
    }
    RecordIndex index;
    index.classes_.assign(scenarios, no_class);
    index.counts_.assign(scenarios, 0);
    index.summary_.total = scenarios;
    Sums sums;
    parallel_for(pool, records.blocks(), [&](std::size_t block) {
        const bool is_stopped = stop && stop();
        auto read =
            is_stopped ? Result<std::vector<KeptRecord>>(interrupted()) : records.read(block);
        ContactMapSum map;
        if (read) {
            for (const KeptRecord& record : read.value()) {
                const bool are_hits = record.result.question == Question::Shots;
                map.add(are_hits ? crossings_of(record.result) : record.result.pairs);
            }
        }
        const std::scoped_lock lock(sums.mutex);
        if (!read) {
            sums.status = read.error();
            return;
        }
        sums.map.add(map.take());
        for (const KeptRecord& record : read.value()) {
            if (record.result.index < scenarios) {
                index.add(record.result);
            }
        }
    });
    if (!sums.status) {
        return sums.status.error();
    }
    index.map_ = sums.map.map();
    return index;
}

void RecordIndex::add(const ScenarioResult& result) {
    classes_[result.index] = static_cast<std::uint8_t>(result.kind);
    counts_[result.index] = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(pairs_of_class(result), std::numeric_limits<std::uint32_t>::max()));
    count(summary_, result);
    if (result.nearest) {
        distances_.resize(classes_.size(), no_distance);
        distances_[result.index] = result.nearest->distance;
    }
}

double RecordIndex::distance_of(std::uint64_t scenario) const {
    return distances_.empty() ? no_distance : distances_[scenario];
}

void RecordIndex::add_nearest(std::size_t count, std::vector<std::uint64_t>& worst) const {
    std::vector<std::uint64_t> apart;
    for (std::uint64_t scenario = 0; scenario < distances_.size(); ++scenario) {
        if (!is_hit(static_cast<ScenarioClass>(classes_[scenario])) &&
            !std::isnan(distances_[scenario])) {
            apart.push_back(scenario);
        }
    }
    const std::size_t added = std::min(count - worst.size(), apart.size());
    const auto end = apart.begin() + static_cast<std::ptrdiff_t>(added);
    std::ranges::partial_sort(apart, end, {}, [&](std::uint64_t scenario) {
        return std::pair(distances_[scenario], scenario);
    });
    worst.insert(worst.end(), apart.begin(), end);
}

std::vector<std::uint64_t> RecordIndex::worst(std::size_t count) const {
    const auto badness = [&](std::uint64_t scenario) {
        return Badness{severity(static_cast<ScenarioClass>(classes_[scenario])), counts_[scenario]};
    };
    std::vector<std::uint64_t> worst;
    for (std::uint64_t scenario = 0; scenario < classes_.size(); ++scenario) {
        if (!is_hit(static_cast<ScenarioClass>(classes_[scenario]))) {
            continue;
        }
        const auto is_better = [&](std::uint64_t each) {
            return badness(each) < badness(scenario);
        };
        const auto place = std::ranges::find_if(worst, is_better);
        if (place != worst.end() || worst.size() < count) {
            worst.insert(place, scenario);
            worst.resize(std::min(worst.size(), count));
        }
    }
    add_nearest(count, worst);
    return worst;
}

std::optional<std::uint64_t>
RecordIndex::next(const NextContact& wanted, const std::function<bool(std::uint64_t)>& fits) const {
    const std::uint64_t total = classes_.size();
    std::uint64_t scenario = std::min(wanted.from, wanted.is_backwards ? total : total - 1);
    while (wanted.is_backwards ? scenario > 0 : scenario + 1 < total) {
        scenario += wanted.is_backwards ? std::uint64_t(-1) : 1;
        if (wanted.has_class(classes_[scenario]) && fits(scenario)) {
            return scenario;
        }
    }
    return std::nullopt;
}

} // namespace cd
