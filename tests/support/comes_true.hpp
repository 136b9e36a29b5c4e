// Waits for conditions in tests with real processes.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace cd::tests {

/// Polls until the condition holds; returns false after one minute.
[[nodiscard]] inline bool comes_true(const std::function<bool()>& condition) {
    const auto give_up_at = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > give_up_at) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

} // namespace cd::tests
