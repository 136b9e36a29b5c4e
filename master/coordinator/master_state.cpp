#include "master/coordinator/master_state.hpp"

#include <random>
#include <utility>

namespace cd {

namespace {

double seconds_of(EventLoop::Duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

MasterState::MasterState(const CoordinatorParts& parts, const Hooks& hooks)
    : loop(parts.loop),
      background(loop, parts.compute, parts.blocking, hooks.after_each),
      jobs(limits::results_ended_kept_max, parts.options.retention, [this] { return loop.now(); }),
      waits(parts.executor),
      workers(parts.options.times,
              std::random_device{}() | std::uint64_t{std::random_device{}()} << 32,
              hooks.workers,
              [this] { return loop.now(); }),
      blocks({parts.executor, loop, parts.network, parts.compute, trees}),
      dispatch([this, begin = loop.now()] { return seconds_of(loop.now() - begin); },
               hooks.perform,
               parts.options.dispatch),
      writer([&thread = parts.loop](std::function<void()> run) { thread.post(std::move(run)); },
             parts.journal),
      retries(loop) {}

} // namespace cd
