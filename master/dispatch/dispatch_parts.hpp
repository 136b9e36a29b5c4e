// The parts of the dispatcher.
#pragma once

#include "master/dispatch/allocator.hpp"
#include "master/dispatch/blocks/block_needs.hpp"
#include "master/dispatch/blocks/block_plan.hpp"
#include "master/dispatch/endgame/endgame.hpp"
#include "master/dispatch/order/worker_filler.hpp"
#include "master/dispatch/policy/rebalancer.hpp"
#include "master/dispatch/range_sender.hpp"
#include "master/dispatch/task_table.hpp"
#include "master/dispatch/work_queue.hpp"
#include "master/dispatch/workers/cluster_pace.hpp"
#include "master/dispatch/workers/worker_pool.hpp"

namespace cd {

struct DispatchParts {
    ClusterPace pace;
    WorkerPool pool;
    BlockPlan plan;
    WorkQueue queue;
    MatchingContext context{pool, plan, queue, pace};
    TaskTable tasks{pool, plan, queue, pace};
    BlockNeeds blocks{plan, pool, pace};
    RangeSender ranges{context, queue, tasks};
    WorkerFiller filler{context, queue, tasks, blocks, ranges};
    Allocator allocator{context, queue, tasks, blocks, filler};
    Rebalancer rebalancer{context, queue, blocks, filler};
    Endgame endgame{context, tasks, blocks};
};

} // namespace cd
