// How a pose file names its scenarios, and at which times they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

struct PoseLabels;

/// What the ids of a pose file are.
enum class IdKind : std::uint8_t { None = 0, Integer = 1, Text = 2 };

/// Which columns labels have.
struct LabelColumns {
    IdKind ids = IdKind::None;
    bool has_times = false;

    [[nodiscard]] bool is_empty() const { return ids == IdKind::None && !has_times; }
    /// Whether these are labels of so many scenarios, in these columns.
    [[nodiscard]] bool fit(const PoseLabels& labels, std::size_t scenarios) const;

    friend bool operator==(const LabelColumns&, const LabelColumns&) = default;
};

/// The columns `id` and `t` of a run of scenarios. A column that the pose file does not have is
/// empty; another one has an entry for each scenario. Ids are integers or texts, never both.
struct PoseLabels {
    std::vector<std::int64_t> integers;
    std::vector<std::string> texts;
    std::vector<double> times; ///< As in the file, in its unit of time.

    [[nodiscard]] LabelColumns columns() const;
    [[nodiscard]] bool is_empty() const { return columns().is_empty(); }
    /// Those of `count` scenarios from `first` on, which are there.
    [[nodiscard]] PoseLabels slice(std::size_t first, std::size_t count) const;
    /// Those of the scenarios that follow, in the same columns.
    void append(const PoseLabels& next);
    /// The labels of i at places[i]; `places` are the numbers below the count of labels, each once.
    [[nodiscard]] PoseLabels moved_to(const std::vector<std::size_t>& places) const;

    friend bool operator==(const PoseLabels&, const PoseLabels&) = default;
};

/// Adds an id as a text file has it: ids are integers as long as each is written as `to_string`
/// writes it; with the first other one all become texts.
void add_pose_id(PoseLabels& labels, std::string_view id);

} // namespace cd
