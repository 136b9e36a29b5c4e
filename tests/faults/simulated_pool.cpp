#include "tests/faults/simulated_pool.hpp"

#include <chrono>
#include <utility>

namespace cd::tests {

namespace {

constexpr Duration work_min = std::chrono::microseconds(200);
constexpr Duration work_max = std::chrono::milliseconds(40);
/// Time of one read of the clock on a host of normal speed.
constexpr Duration look_time = std::chrono::microseconds(20);

} // namespace

void SimulatedPool::post(std::function<void()> function) {
    waiting_.push_back(std::move(function));
    start_next();
}

void SimulatedPool::start_next() {
    if (free_ == 0 || waiting_.empty()) {
        return;
    }
    --free_;
    const std::uint64_t number = world_.new_number();
    running_.emplace(number, std::move(waiting_.front()));
    waiting_.pop_front();
    const Duration work = world_.between(work_min, work_max);
    if (host_.slowed_at != Time{} && host_.slowness >= 2) {
        world_.felt(Trouble::WorkerSlowed, host_, host_.slowed_at);
    }
    run_at(world_.now() + std::chrono::duration_cast<Duration>(work * host_.slowness), number);
}

void SimulatedPool::run_at(Time time, std::uint64_t number) {
    world_.at(time, [this, number, weak = std::weak_ptr(is_here_)] {
        if (!weak.expired()) {
            run(number);
        }
    });
}

void SimulatedPool::run(std::uint64_t number) {
    if (world_.is_stopped(host_)) {
        world_.felt_stop(host_);
        return run_at(host_.stopped_until, number);
    }
    ++free_;
    const auto running = running_.extract(number);
    world_.work_slowly(std::chrono::duration_cast<Duration>(look_time * host_.slowness),
                       running.mapped());
    world_.wake(host_);
    start_next();
}

} // namespace cd::tests
