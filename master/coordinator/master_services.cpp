#include "master/coordinator/master_services.hpp"

#include <optional>
#include <utility>

namespace cd {

MasterServices::MasterServices(const CoordinatorParts& parts, MasterState& state)
    : references(state.background),
      life({state.jobs,
            state.workers,
            state.trees,
            state.blocks,
            state.dispatch,
            state.writer,
            state.retries},
           {[this](JobId job) { (void)references.stop(job, std::nullopt); },
            [this] { work.feed(); }}),
      merger(life, state.writer, parts.options.cpu_seconds),
      tasks(state.jobs, state.workers, state.trees, state.dispatch),
      ranges({state.jobs, life, state.dispatch, state.writer, state.background}),
      analyses({state.jobs, life, merger, state.dispatch, state.background, parts.options.feed}),
      work({state.loop,
            state.jobs,
            state.workers,
            state.awaited,
            life,
            state.dispatch,
            state.writer,
            state.background,
            ranges,
            analyses,
            parts.options.feed}),
      quarantine({state.jobs,
                  state.workers,
                  state.blocks,
                  tasks,
                  ranges,
                  state.dispatch,
                  state.alarms,
                  state.writer}),
      arbiter(
          {state.jobs, life, state.dispatch, references, state.alarms, quarantine, state.writer}),
      ingest({state.jobs,
              life,
              merger,
              tasks,
              state.workers,
              state.alarms,
              state.awaited,
              state.dispatch,
              state.writer,
              state.background},
             parts.options.results_aside_bytes_max,
             parts.options.check),
      start({parts.geometry,
             state.jobs,
             life,
             state.workers,
             state.trees,
             state.dispatch,
             state.background,
             parts.options.knows_owners},
            [this](MasterJob& job) { started(job); }) {}

void MasterServices::started(MasterJob& job) {
    ingest.take_up(job.id);
    for (const Dispute& dispute : std::exchange(job.run->disputes_before, {})) {
        arbiter.settle(dispute);
    }
}

} // namespace cd
