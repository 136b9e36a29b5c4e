// The dispatcher's parts with a job and workers, for tests of one part by itself.
#pragma once

#include "master/dispatch/dispatch_parts.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace cd::tests {

/// Each job has two trees, of four roots of 100 triangles and of one of one triangle.
struct DispatchStage : DispatchParts {
    WorkerProxy& join(std::uint64_t worker, std::uint32_t threads = 1) {
        WorkerFacts facts{"w" + std::to_string(worker), threads};
        facts.process = worker;
        return join(worker, facts);
    }
    WorkerProxy& join(std::uint64_t worker, const WorkerFacts& facts) {
        WorkerProxy& proxy = pool.add(WorkerId{worker}, facts);
        plan.join(proxy.slot());
        return proxy;
    }
    DispatchJob& open(std::uint64_t id, const ClusterOptions& options) {
        const DispatchTree a{TreeId{1}, {100, 100, 100, 100}, {6400, 6400, 6400, 6400}};
        const DispatchTree b{TreeId{2}, {1}, {64}};
        plan.add_tree(a);
        plan.add_tree(b);
        queue.open(JobId{id}, options, {a, b}, make_policy(options, context));
        return queue.at(JobId{id});
    }
    DispatchJob& open(std::string_view strategy, std::uint32_t q = 2, std::uint64_t id = 1) {
        ClusterOptions options;
        options.strategy = strategy;
        options.q = q;
        return open(id, options);
    }
    /// A scenario of 1 ms and 100 bytes that touches root 0 of the second tree.
    static DispatchScenario scenario(const DispatchJob& job,
                                     std::vector<RootIndex> roots_a = {0},
                                     std::uint64_t cost_ns = 1'000'000) {
        return job.scenario_of({0, std::move(roots_a), {0}, 100, cost_ns});
    }
    void add(DispatchJob& job, std::uint64_t count, std::uint64_t cost_ns = 1'000'000) {
        for (std::uint64_t i = 0; i < count; ++i) {
            queue.add(job, next++, scenario(job, {0}, cost_ns));
        }
    }
    /// Sends scenarios from the queue to the worker.
    void send(WorkerProxy& proxy, DispatchJob& job, std::uint64_t count) {
        const auto end = job.waiting.begin() + static_cast<std::ptrdiff_t>(count);
        std::vector<std::uint64_t> first(job.waiting.begin(), end);
        job.waiting.erase(job.waiting.begin(), end);
        tasks.send(proxy, job, std::move(first), false, actions);
    }
    /// The last action, which must be of this type.
    template <class Type>
    [[nodiscard]] const Type& last() const {
        return std::get<Type>(actions.back());
    }

    Actions actions;
    std::uint64_t next = 0;
};

} // namespace cd::tests
