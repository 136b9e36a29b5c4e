// Waiting, in tests with real processes, for what somebody else does.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace cd::tests {

/// Until it is so (then true), or a minute has gone by.
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
