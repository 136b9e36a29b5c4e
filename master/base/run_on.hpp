// Lets a coroutine wait for work on a thread pool.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "proto/channel/asio.hpp"

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace cd {

/// Runs `function` on the pool and resumes on the coroutine's own executor with its return value.
/// The executor's context must outlive the pool.
template <class Function>
asio::awaitable<std::invoke_result_t<Function&>> run_on(Pool& pool, Function function) {
    struct Shared {
        Shared(asio::any_io_executor executor, Function f)
            : done(executor, asio::steady_timer::time_point::max()), function(std::move(f)) {}
        asio::steady_timer done;
        Function function;
        std::optional<std::invoke_result_t<Function&>> value;
    };
    const asio::any_io_executor executor = co_await asio::this_coro::executor;
    const auto shared = std::make_shared<Shared>(executor, std::move(function));
    pool.post([executor, shared] {
        shared->value.emplace(shared->function());
        // Posted, because only the executor's thread may use the timer. The coroutine waits for the
        // timer by the time this handler runs.
        asio::post(executor, [shared] { shared->done.cancel(); });
    });
    boost::system::error_code ignored;
    co_await shared->done.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    co_return std::move(*shared->value);
}

} // namespace cd
