// Events of a simulation in simulated time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>

namespace cd::bench {

/// Pending events, ordered by time, then by insertion.
class Agenda {
  public:
    void at(double time, std::function<void()> what) {
        entries_.push({std::max(time, now_), next_++, std::move(what)});
    }
    /// Returns false when no event is left.
    bool step() {
        if (entries_.empty()) {
            return false;
        }
        const auto what = entries_.top().what;
        now_ = entries_.top().time;
        entries_.pop();
        what();
        return true;
    }
    [[nodiscard]] double now() const { return now_; }

  private:
    struct Entry {
        double time = 0;
        std::uint64_t number = 0;
        std::function<void()> what;

        bool operator<(const Entry& other) const {
            return std::pair(time, number) > std::pair(other.time, other.number);
        }
    };
    std::priority_queue<Entry> entries_;
    std::uint64_t next_ = 0;
    double now_ = 0;
};

} // namespace cd::bench
