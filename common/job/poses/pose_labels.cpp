#include "common/job/poses/pose_labels.hpp"

#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

namespace cd {

namespace {

template <class T>
std::vector<T> slice_of(const std::vector<T>& values, std::size_t first, std::size_t count) {
    if (values.empty()) {
        return {};
    }
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

template <class T>
void append_to(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

template <class T>
std::vector<T> moved(const std::vector<T>& values, const std::vector<std::size_t>& places) {
    std::vector<T> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        result[places[i]] = values[i];
    }
    return result;
}

std::optional<std::int64_t> to_integer(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_integer = error == std::errc() && end == text.data() + text.size();
    return is_integer && std::to_string(value) == text ? std::optional(value) : std::nullopt;
}

} // namespace

bool LabelColumns::fit(const PoseLabels& labels, std::size_t scenarios) const {
    return labels.integers.size() == (ids == IdKind::Integer ? scenarios : 0) &&
           labels.texts.size() == (ids == IdKind::Text ? scenarios : 0) &&
           labels.times.size() == (has_times ? scenarios : 0) &&
           labels.end_times.size() == (has_end_times ? scenarios : 0);
}

LabelColumns PoseLabels::columns() const {
    const IdKind ids = !integers.empty() ? IdKind::Integer
                       : !texts.empty()  ? IdKind::Text
                                         : IdKind::None;
    return {ids, !times.empty(), !end_times.empty()};
}

PoseLabels PoseLabels::slice(std::size_t first, std::size_t count) const {
    return {slice_of(integers, first, count),
            slice_of(texts, first, count),
            slice_of(times, first, count),
            slice_of(end_times, first, count)};
}

void PoseLabels::append(const PoseLabels& next) {
    append_to(integers, next.integers);
    append_to(texts, next.texts);
    append_to(times, next.times);
    append_to(end_times, next.end_times);
}

double PoseLabels::time_at(std::size_t scenario, double tau) const {
    if (end_times.empty()) {
        return static_cast<double>(scenario) + tau;
    }
    return std::lerp(times[scenario], end_times[scenario], tau);
}

PoseLabels PoseLabels::moved_to(const std::vector<std::size_t>& places) const {
    return {moved(integers, places),
            moved(texts, places),
            moved(times, places),
            moved(end_times, places)};
}

void add_pose_id(PoseLabels& labels, std::string_view id) {
    const auto integer = labels.texts.empty() ? to_integer(id) : std::nullopt;
    if (integer) {
        labels.integers.push_back(*integer);
        return;
    }
    for (const std::int64_t each : labels.integers) {
        labels.texts.push_back(std::to_string(each));
    }
    labels.integers.clear();
    labels.texts.emplace_back(id);
}

} // namespace cd
