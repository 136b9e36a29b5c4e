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

/// States which columns the labels of a pose file have.
struct LabelColumns {
    IdKind ids = IdKind::None;
    bool has_times = false;
    bool has_end_times = false; ///< Only with `has_times`.

    [[nodiscard]] bool is_empty() const { return ids == IdKind::None && !has_times; }
    /// Returns true if the labels have these columns, each with one entry per scenario.
    [[nodiscard]] bool fit(const PoseLabels& labels, std::size_t scenarios) const;

    friend bool operator==(const LabelColumns&, const LabelColumns&) = default;
};

/// The columns `id` and `t` of consecutive scenarios, and `t_end` of motions. A column that the
/// pose file lacks is empty; any other has one entry per scenario. Ids are either all integers or
/// all texts.
struct PoseLabels {
    std::vector<std::int64_t> integers;
    std::vector<std::string> texts;
    std::vector<double> times; ///< Values of the file, in its unit of time.
    /// For motions between poses with times: the time of the pose at each motion's end. `times`
    /// has that of its begin.
    std::vector<double> end_times = {};

    [[nodiscard]] LabelColumns columns() const;
    [[nodiscard]] bool is_empty() const { return columns().is_empty(); }
    /// Returns the labels of scenarios [first, first + count), which exist.
    [[nodiscard]] PoseLabels slice(std::size_t first, std::size_t count) const;
    /// Appends the labels of the next scenarios; the columns are equal.
    void append(const PoseLabels& next);
    /// Returns the time at `tau` in [0, 1] of a scenario's motion; without times the scenario's
    /// number plus tau.
    [[nodiscard]] double time_at(std::size_t scenario, double tau) const;
    /// Returns the labels with label i at index places[i]. `places` is a permutation.
    [[nodiscard]] PoseLabels moved_to(const std::vector<std::size_t>& places) const;

    friend bool operator==(const PoseLabels&, const PoseLabels&) = default;
};

/// Adds an id of a text file. Ids are integers as long as each is spelled as `std::to_string` would
/// spell it. The first other id turns all ids into texts.
void add_pose_id(PoseLabels& labels, std::string_view id);

} // namespace cd
