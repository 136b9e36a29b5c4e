#include "proto/channel/asio.hpp"

#include "common/core/host/log.hpp"

#include <exception>
#include <utility>

namespace cd {

void spawn(asio::any_io_executor executor, std::string name, asio::awaitable<void> coroutine) {
    asio::co_spawn(
        executor, std::move(coroutine), [name = std::move(name)](const std::exception_ptr& thrown) {
            if (!thrown) {
                return;
            }
            try {
                std::rethrow_exception(thrown);
            } catch (const std::exception& error) {
                log_error("coroutine failed: name={} error={}", name, error.what());
            }
        });
}

} // namespace cd
