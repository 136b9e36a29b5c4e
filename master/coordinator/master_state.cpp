#include "master/coordinator/master_state.hpp"

#include <random>
#include <utility>

namespace cd {

namespace {

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

} // namespace

MasterState::MasterState(const CoordinatorParts& parts, const Hooks& hooks)
    : background(parts.executor, parts.compute, parts.blocking, hooks.after_each),
      timers(parts.executor),
      jobs(limits::results_ended_kept_max, parts.retention),
      waits(parts.executor),
      workers(parts.times,
              std::random_device{}() | std::uint64_t{std::random_device{}()} << 32,
              hooks.workers,
              Clock::now),
      blocks(parts.executor, trees),
      dispatch([begin = Clock::now()] { return seconds_since(begin); }, hooks.perform),
      writer([executor = parts.executor](
                 std::function<void()> run) { asio::post(executor, std::move(run)); },
             parts.journal),
      retries(parts.executor) {}

} // namespace cd
