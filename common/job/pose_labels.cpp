#include "common/job/pose_labels.hpp"

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

} // namespace

bool LabelColumns::fit(const PoseLabels& labels, std::size_t scenarios) const {
    return labels.integers.size() == (ids == IdKind::Integer ? scenarios : 0) &&
           labels.texts.size() == (ids == IdKind::Text ? scenarios : 0) &&
           labels.times.size() == (has_times ? scenarios : 0);
}

LabelColumns PoseLabels::columns() const {
    const IdKind ids = !integers.empty() ? IdKind::Integer
                       : !texts.empty()  ? IdKind::Text
                                         : IdKind::None;
    return {ids, !times.empty()};
}

PoseLabels PoseLabels::slice(std::size_t first, std::size_t count) const {
    return {slice_of(integers, first, count),
            slice_of(texts, first, count),
            slice_of(times, first, count)};
}

void PoseLabels::append(const PoseLabels& next) {
    append_to(integers, next.integers);
    append_to(texts, next.texts);
    append_to(times, next.times);
}

} // namespace cd
