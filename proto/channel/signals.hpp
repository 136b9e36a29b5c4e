// SIGINT and SIGTERM as events on an executor.
#pragma once

#include "proto/channel/asio.hpp"

#include <functional>
#include <memory>

namespace cd {

/// While alive, calls `act(n)` on the executor's thread for the n-th SIGINT or SIGTERM, from 1. A
/// daemon drains at the first and ends at the second. Keeps the executor's context busy until
/// destruction or `cancel`; after that a signal ends the process.
class StopSignals {
  public:
    StopSignals(const asio::any_io_executor& executor, std::function<void(unsigned)> act);
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;
    ~StopSignals();

    void cancel();

  private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace cd
