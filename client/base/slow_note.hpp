// A message to the user if a step takes long.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace cd {

/// Prints `text` as a line on stderr if the object lives longer than half a second.
class SlowNote {
  public:
    /// `text` is the note's line. `quiet` disables the note.
    SlowNote(std::string text, bool quiet);
    SlowNote(const SlowNote&) = delete;
    SlowNote& operator=(const SlowNote&) = delete;
    ~SlowNote();

  private:
    void wait();

    std::string text_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool is_over_ = false;
    std::thread thread_; ///< Not started if the note is disabled.
};

} // namespace cd
