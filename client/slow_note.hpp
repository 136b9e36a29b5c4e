// A line for people about work that turns out to be slow.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace cd {

/// Prints `text` as a line on stderr once half a second has passed and this still lives.
class SlowNote {
  public:
    /// `quiet`: never prints.
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
    std::thread thread_; ///< None where it is quiet.
};

} // namespace cd
