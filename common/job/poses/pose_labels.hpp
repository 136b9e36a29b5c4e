// The ids and times that a pose file gives its scenarios.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

struct PoseLabels;

/// The type of a pose file's ids.
enum class IdKind : std::uint8_t { None = 0, Integer = 1, Text = 2 };

/// The columns that labels have.
struct LabelColumns {
    IdKind ids = IdKind::None;
    bool has_times = false;

    [[nodiscard]] bool is_empty() const { return ids == IdKind::None && !has_times; }
    /// Whether the labels have these columns, each with an entry for every scenario.
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
    /// The labels of scenarios [first, first + count), which must exist.
    [[nodiscard]] PoseLabels slice(std::size_t first, std::size_t count) const;
    /// Adds the labels of the scenarios that follow; the columns must be equal.
    void append(const PoseLabels& next);
    /// Moves the label of i to places[i]. `places` is a permutation of the labels' numbers.
    [[nodiscard]] PoseLabels moved_to(const std::vector<std::size_t>& places) const;

    friend bool operator==(const PoseLabels&, const PoseLabels&) = default;
};

/// Adds an id of a text file. Ids are integers as long as each is spelled as `to_string` spells it;
/// the first other id turns all of them into texts.
void add_pose_id(PoseLabels& labels, std::string_view id);

} // namespace cd
