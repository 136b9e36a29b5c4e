#include "client/base/slow_note.hpp"

#include "common/core/timing/client.hpp"

#include <cstdio>
#include <utility>

namespace cd {

SlowNote::SlowNote(std::string text, bool quiet) : text_(std::move(text)) {
    if (!quiet) {
        thread_ = std::thread([this] { wait(); });
    }
}

SlowNote::~SlowNote() {
    {
        const std::lock_guard lock(mutex_);
        is_over_ = true;
    }
    ended_.notify_all();
    if (thread_.joinable()) {
        thread_.join();
    }
}

void SlowNote::wait() {
    std::unique_lock lock(mutex_);
    if (!ended_.wait_for(lock, timing::slow_note_after, [this] { return is_over_; })) {
        std::fprintf(stderr, "%s\n", text_.c_str());
    }
}

} // namespace cd
