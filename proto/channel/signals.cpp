#include "proto/channel/signals.hpp"

#include <csignal>

namespace cd {

struct StopSignals::State : std::enable_shared_from_this<State> {
    State(const asio::any_io_executor& executor, std::function<void(unsigned)> function)
        : signals(executor, SIGINT, SIGTERM), act(std::move(function)) {}

    void wait() {
        signals.async_wait(
            [self = shared_from_this()](const boost::system::error_code& error, int) {
                if (error || self->cancelled) {
                    return;
                }
                self->wait();
                self->act(++self->count);
            });
    }

    asio::signal_set signals;
    std::function<void(unsigned)> act;
    unsigned count = 0;
    bool cancelled = false;
};

StopSignals::StopSignals(const asio::any_io_executor& executor, std::function<void(unsigned)> act)
    : state_(std::make_shared<State>(executor, std::move(act))) {
    state_->wait();
}

StopSignals::~StopSignals() {
    cancel();
}

void StopSignals::cancel() {
    // A queued signal is delivered even after the cancel.
    state_->cancelled = true;
    boost::system::error_code ignored;
    state_->signals.cancel(ignored);
    state_->signals.clear(ignored);
}

} // namespace cd
