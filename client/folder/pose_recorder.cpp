#include "client/folder/pose_recorder.hpp"

#include <algorithm>
#include <span>

namespace cd {

namespace {

constexpr std::uint64_t scenarios_at_once = 4096;

} // namespace

Result<std::vector<Scenario>> PoseRecorder::read(std::uint64_t first, std::uint64_t count) {
    auto scenarios = source_->read(first, count);
    if (!scenarios) {
        return scenarios;
    }
    const std::lock_guard lock(mutex_);
    const std::uint64_t written = writer_.written();
    if (first <= written && written < first + count) {
        const auto news = std::span<const Scenario>(scenarios.value()).subspan(written - first);
        if (Status added = writer_.add(news); !added) {
            return added.error();
        }
    }
    return scenarios;
}

Status PoseRecorder::finish() {
    while (writer_.written() < count()) {
        const std::uint64_t first = writer_.written();
        if (const auto more = read(first, std::min(scenarios_at_once, count() - first)); !more) {
            return more.error();
        }
    }
    return writer_.finish();
}

} // namespace cd
