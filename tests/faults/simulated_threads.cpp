// Replaces threads: posted functions run at simulated times. A failed CD_CHECK becomes a problem of
// the simulation.
#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "tests/faults/world.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace cd {

using tests::World;

ThreadPool::ThreadPool(unsigned threads) {
    threads_.resize(std::max(1u, threads)); // Only `size` reads these; none runs.
    if (World* world = World::current()) {
        world->pool_made(this, size());
    }
}

ThreadPool::~ThreadPool() {
    if (World* world = World::current()) {
        world->pool_gone(this);
    }
}

void ThreadPool::post(std::function<void()> function) {
    if (World* world = World::current()) {
        world->post(this, std::move(function));
    } else {
        function();
    }
}

void parallel_for(ThreadPool&,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function) {
    for (std::size_t i = 0; i < count; ++i) {
        function(i);
    }
}

void parallel_for(ThreadPool*,
                  std::size_t count,
                  const std::function<void(std::size_t)>& function) {
    for (std::size_t i = 0; i < count; ++i) {
        function(i);
    }
}

void check_failed(const char* condition, const char* file, int line) {
    const std::string what = std::string(condition) + " at " + file + ":" + std::to_string(line);
    if (World* world = World::current()) {
        world->check_failed(what);
    }
    std::fprintf(stderr, "broken invariant: %s\n", what.c_str());
    std::abort();
}

} // namespace cd
