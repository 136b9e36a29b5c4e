// The unanswered scenarios of a session whose roots are known.
#pragma once

#include "proto/messages/work_messages.hpp"

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cd {

/// A queue in which a scenario waits for its subtrees, then for a thread, then runs.
class ScenarioQueue {
  public:
    using Token = std::uint64_t; ///< Identifies a scenario; used once; never 0.
    struct Entry {
        Token token = 0;
        TaskId task;
        std::size_t scenario = 0; ///< Position in the task.
        /// Set by the thread that begins the scenario or by `drop_unbegun`, whichever is first.
        /// The flag is null before the scenario is submitted to a thread.
        std::shared_ptr<std::atomic<bool>> has_begun;
    };

    /// Adds a scenario that waits for its subtrees.
    [[nodiscard]] Token add(TaskId task, std::size_t scenario);
    /// Marks scenarios, which are in the queue, as waiting only for a thread.
    void set_ready(std::span<const Token> tokens);
    /// Takes the next scenario for a thread, in the order of `set_ready`, and sets its `has_begun`
    /// to a new flag. Empty if none is ready.
    [[nodiscard]] std::optional<Entry> begin_next();
    /// Removes and returns a scenario that a thread has run. Returns nothing if `drop_unbegun` had
    /// removed the scenario.
    [[nodiscard]] std::optional<Entry> finish(Token token);
    /// Removes the scenarios that match `concerned` and have not begun, and returns them.
    std::vector<Entry> drop_unbegun(const std::function<bool(const Entry&)>& concerned);

    [[nodiscard]] std::size_t size() const { return entries_.size(); }

  private:
    std::map<Token, Entry> entries_;
    std::deque<Token> ready_; ///< Ready scenarios that no thread has.
    Token last_ = 0;
};

} // namespace cd
