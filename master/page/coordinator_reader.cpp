#include "master/page/coordinator_reader.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/timing/web.hpp"
#include "master/compute/job_geometry.hpp"
#include "master/geometry/mesh_file.hpp"
#include "master/page/state_sizes.hpp"
#include "master/submission/label_spool.hpp"
#include "web/server/cluster/result_records.hpp"

#include <utility>

namespace cd {

namespace {

/// Reads the records of a job, whose store stays alive.
RecordReader reader_of(std::shared_ptr<ResultStore> store) {
    return [store = std::move(store)](
               std::uint64_t first, std::uint64_t count, const auto& take) -> Status {
        const std::uint64_t end = first + count;
        while (first < end) {
            const auto part = store->read(first, end - first, limits::results_part_bytes_target);
            if (!part) {
                return part.error();
            }
            const auto results = unpack_results(part.value(), first, end - first);
            if (!results) {
                return results.error();
            }
            for (const ScenarioResult& result : results.value()) {
                if (const Status taken = take(result); !taken) {
                    return taken;
                }
            }
            first = part.value().next;
        }
        return Done{};
    };
}

Result<PoseLabels> labels_of(const JobRecord& record,
                             const std::filesystem::path& path,
                             std::uint64_t first,
                             std::uint64_t count) {
    const Submit& submit = record.submit;
    if (submit.poses.labels.is_empty()) {
        return PoseLabels();
    }
    const auto spool = LabelSpool::open(path, submit.poses.labels, submit.scenarios);
    return spool ? spool.value()->read(first, count) : spool.error();
}

} // namespace

struct CoordinatorReader::Sizes {
    StateSizes now;
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
        loop.post([sizes, measured] {
            sizes->now = measured;
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

void CoordinatorReader::map(const ContactMapQuery& query, Take<ContactMapAnswer> take) {
    take(coordinator_.jobs().contact_map(query));
}

Result<RecordReader> CoordinatorReader::records(JobId job) {
    const MasterJob* const found = coordinator_.jobs().find(job);
    if (found == nullptr) {
        return no_job();
    }
    return reader_of(found->results);
}

Status CoordinatorReader::may_run() {
    const std::string why = reason_of_pause(coordinator_);
    return why.empty() ? Status(Done{})
                       : Error{ErrorCode::TooLarge, "no scenario is run again: " + why};
}

Result<JobDescription> CoordinatorReader::description(JobId job) {
    return queries_.description(job);
}

Result<LabelledScenarios>
CoordinatorReader::poses(JobId job, std::uint64_t first, std::uint64_t count) {
    const Journal& journal = coordinator_.parts().journal;
    const Result<JobRecord> record = journal.job(job);
    if (!record) {
        return record.error();
    }
    const auto source =
        open_poses(record.value().submit, journal.poses_path(job), PoseCheck::AsRead);
    if (!source) {
        return source.error();
    }
    auto scenarios = source.value()->read_submitted(first, count);
    if (!scenarios) {
        return scenarios.error();
    }
    auto labels = labels_of(record.value(), journal.labels_path(job), first, count);
    if (!labels) {
        return labels.error();
    }
    return LabelledScenarios{std::move(scenarios.value()), std::move(labels.value())};
}

Result<BodyTrees> CoordinatorReader::trees(const Submit& submit) {
    BodyTrees trees;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        auto tree = coordinator_.parts().store->tree(submit.bodies[i].mesh);
        if (!tree) {
            return tree.error();
        }
        trees[i] = std::move(tree.value());
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
