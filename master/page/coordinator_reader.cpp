#include "master/page/coordinator_reader.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/web.hpp"
#include "master/geometry/mesh_file.hpp"
#include "master/page/state_sizes.hpp"
#include "web/server/cluster/result_records.hpp"

#include <utility>

namespace cd {

namespace {

/// Reads the records of a job, whose store stays alive.
RecordReader reader_of(JobId job, std::uint64_t scenarios, std::shared_ptr<ResultStore> store) {
    return [job, scenarios, store = std::move(store)](const ScenarioChoice& choice,
                                                      const TakeRecord& take) {
        return for_each_result(
            query_of<ResultsQuery>(job, choice),
            scenarios,
            [&](const ResultsQuery& query) {
                return store->read(
                    query.first, query.count, limits::results_part_bytes_target, query.sample);
            },
            take);
    };
}

} // namespace

struct CoordinatorReader::Sizes {
    StateSizes now;
    std::uint64_t disk = 0; ///< Size of the file system.
    std::chrono::steady_clock::time_point measured;
    bool is_measuring = false;
};

CoordinatorReader::CoordinatorReader(Coordinator& coordinator)
    : coordinator_(coordinator),
      queries_(coordinator.parts().journal, *coordinator.parts().store),
      sizes_(std::make_shared<Sizes>()) {}

void CoordinatorReader::measure() {
    const auto now = coordinator_.parts().loop.now();
    if (sizes_->is_measuring || now - sizes_->measured < timing::history_period) {
        return;
    }
    sizes_->is_measuring = true;
    sizes_->measured = now;
    const auto state = coordinator_.parts().directory.parent_path();
    coordinator_.parts().blocking.post([sizes = sizes_, state, &loop = coordinator_.parts().loop] {
        const StateSizes measured = measure_state(state);
        const std::uint64_t disk = disk_bytes(state);
        loop.post([sizes, measured, disk] {
            sizes->now = measured;
            sizes->disk = disk;
            sizes->is_measuring = false;
        });
    });
}

void CoordinatorReader::status(Take<ClusterStatus> take) {
    measure();
    ClusterStatus status = coordinator_.jobs().cluster();
    status.sizes = sizes_->now;
    take(std::move(status));
}

std::uint64_t CoordinatorReader::disk() const {
    return sizes_->disk;
}

void CoordinatorReader::map(const ContactMapQuery& query, Take<ContactMapAnswer> take) {
    take(coordinator_.jobs().contact_map(query));
}

Result<RecordReader> CoordinatorReader::records(JobId job, std::uint64_t scenarios) {
    const MasterJob* const found = coordinator_.jobs().find(job);
    if (found == nullptr) {
        return no_job();
    }
    return reader_of(job, scenarios, found->results);
}

Status CoordinatorReader::may_run() {
    const std::string why = reason_of_pause(coordinator_);
    return why.empty() ? Status(Done{})
                       : Error{ErrorCode::TooLarge, "no scenario is run again: " + why};
}

Result<JobDescription> CoordinatorReader::description(JobId job) {
    return queries_.description(job);
}

Result<LabelledScenarios> CoordinatorReader::poses(JobId job, const ScenarioChoice& choice) {
    return queries_.scenarios(query_of<PosesQuery>(job, choice));
}

Result<BodyTrees> CoordinatorReader::trees(const Submit& submit) {
    BodyTrees trees;
    for (const JobBody& body : submit.bodies) {
        auto tree = coordinator_.parts().store->tree(body.mesh);
        if (!tree) {
            return tree.error();
        }
        trees.push_back(std::move(tree.value()));
    }
    return trees;
}

Result<std::shared_ptr<HttpBody>> CoordinatorReader::mesh(const Sha256& mesh) {
    const CoordinatorParts& parts = coordinator_.parts();
    if (!parts.store->has(mesh)) {
        return Error{ErrorCode::NotFound, "the master has no such mesh"};
    }
    auto file = DiskFile::open(mesh_path(parts.directory.parent_path(), mesh));
    if (!file) {
        return file.error();
    }
    const auto size = file.value().size();
    if (!size) {
        return size.error();
    }
    return make_file_body(std::move(file.value()), size.value(), parts.blocking, parts.executor);
}

std::string reason_of_pause(const Coordinator& coordinator) {
    if (!coordinator.jobs().paused().empty()) {
        return "paused: " + coordinator.jobs().paused();
    }
    for (const JobStatus& job : coordinator.jobs().cluster().jobs) {
        if (!job.paused.empty()) {
            return "job " + std::to_string(job.job.value) + " is paused: " + job.paused;
        }
    }
    return "";
}

} // namespace cd
