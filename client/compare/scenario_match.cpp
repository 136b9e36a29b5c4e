#include "client/compare/scenario_match.hpp"

#include "client/compare/scenario_keys.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace cd {

namespace {

constexpr std::uint64_t keys_at_once = 4096;
constexpr std::uint32_t no_scenario = UINT32_MAX;

using MakeKey = ScenarioKey (*)(const Scenario&);

/// Calls `take` with the key of each scenario, in order.
Status for_each_key(PoseSource& poses,
                    MakeKey key,
                    const StopCheck& stop,
                    const std::function<void(const ScenarioKey&)>& take) {
    for (std::uint64_t first = 0; first < poses.count(); first += keys_at_once) {
        if (stop && stop()) {
            return interrupted();
        }
        const auto scenarios =
            CD_TRY(poses.read(first, std::min(keys_at_once, poses.count() - first)));
        for (const Scenario& scenario : scenarios) {
            take(key(scenario));
        }
    }
    return Done{};
}

bool has_ids(const PoseLabels& labels) {
    return labels.columns().ids != IdKind::None;
}

void for_each_key(const PoseLabels& ids, const std::function<void(const ScenarioKey&)>& take) {
    for (const std::int64_t id : ids.integers) {
        take(key_of(std::to_string(id)));
    }
    for (const std::string& id : ids.texts) {
        take(key_of(id));
    }
}

} // namespace

/// Fills a match from keys.
class ScenarioMatcher {
  public:
    /// `keys` has the keys of the earlier run.
    ScenarioMatcher(MatchedBy by, ScenarioKeys keys, Repeats repeats)
        : keys_(std::move(keys)), repeats_(repeats) {
        keys_.sort();
        match_.by_ = by;
    }

    /// Matches the later run's next scenario.
    void add(const ScenarioKey& key) {
        const auto found = repeats_ == Repeats::Share ? keys_.find(key) : keys_.take(key);
        match_.count_ += found ? 1 : 0;
        match_.earlier_.push_back(found ? static_cast<std::uint32_t>(*found) : no_scenario);
    }

    ScenarioMatch take() { return std::move(match_); }

  private:
    ScenarioKeys keys_;
    Repeats repeats_;
    ScenarioMatch match_;
};

std::string_view to_text(MatchedBy by) {
    constexpr std::array<std::string_view, 4> names{"index", "id", "poses", "step and bodies"};
    return names[static_cast<std::size_t>(by)];
}

ScenarioMatch ScenarioMatch::by_index(std::uint64_t scenarios) {
    ScenarioMatch match;
    match.count_ = scenarios;
    match.by_index_ = scenarios;
    return match;
}

std::optional<std::uint64_t> ScenarioMatch::earlier(std::uint64_t index) const {
    if (index < dropped_.size() && dropped_[index]) {
        return std::nullopt;
    }
    if (index < by_index_) {
        return index;
    }
    if (index >= earlier_.size() || earlier_[index] == no_scenario) {
        return std::nullopt;
    }
    return earlier_[index];
}

void ScenarioMatch::keep_if(std::uint64_t scenarios,
                            const std::function<bool(std::uint64_t earlier)>& keeps) {
    std::vector<bool> dropped(scenarios);
    for (std::uint64_t index = 0; index < scenarios; ++index) {
        const auto found = earlier(index);
        dropped[index] = found && !keeps(*found);
        count_ -= dropped[index] ? 1 : 0;
    }
    dropped_ = std::move(dropped);
}

namespace {

Result<ScenarioMatch> match_keys(MatchedBy by,
                                 MakeKey key,
                                 PoseSource& earlier,
                                 PoseSource& later,
                                 Repeats repeats,
                                 const StopCheck& stop) {
    auto keys = CD_TRY(ScenarioKeys::for_run(earlier.count()));
    CD_TRY(for_each_key(earlier, key, stop, [&](const ScenarioKey& each) { keys.add(each); }));
    ScenarioMatcher matcher(by, std::move(keys), repeats);
    CD_TRY(for_each_key(later, key, stop, [&](const ScenarioKey& each) { matcher.add(each); }));
    return matcher.take();
}

} // namespace

Result<ScenarioMatch>
match_poses(PoseSource& earlier, PoseSource& later, Repeats repeats, const StopCheck& stop) {
    if (earlier.grid() != nullptr && later.grid() != nullptr && *earlier.grid() == *later.grid()) {
        return ScenarioMatch::by_index(later.count());
    }
    return match_keys(MatchedBy::Poses, MakeKey(&key_of), earlier, later, repeats, stop);
}

Result<ScenarioMatch> match_runs(const MatchedRun& earlier,
                                 const MatchedRun& later,
                                 bool are_poses_equal,
                                 const StopCheck& stop) {
    if (are_poses_equal) {
        return ScenarioMatch::by_index(later.poses.count());
    }
    if (earlier.is_scene && later.is_scene) {
        return match_keys(
            MatchedBy::Step, &key_of_step, earlier.poses, later.poses, Repeats::Pair, stop);
    }
    if (!has_ids(earlier.labels) || !has_ids(later.labels)) {
        return match_poses(earlier.poses, later.poses, Repeats::Pair, stop);
    }
    auto keys = CD_TRY(ScenarioKeys::for_run(earlier.poses.count()));
    for_each_key(earlier.labels, [&](const ScenarioKey& key) { keys.add(key); });
    ScenarioMatcher matcher(MatchedBy::Id, std::move(keys), Repeats::Pair);
    for_each_key(later.labels, [&](const ScenarioKey& key) { matcher.add(key); });
    return matcher.take();
}

} // namespace cd
