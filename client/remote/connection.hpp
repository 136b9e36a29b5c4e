// A client's conversation with a master, in calls that wait for their answers.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/pose_labels.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/result.hpp"
#include "proto/channel/tls.hpp"
#include "proto/messages/client_messages.hpp"
#include "proto/messages/identity_messages.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cd {

/// A mesh that a job needs, under the name that people know it by.
struct NamedMesh {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
};

/// Consecutive scenarios and their labels.
struct FetchedPoses {
    std::vector<Scenario> scenarios;
    PoseLabels labels;
};

/// One connection, used by one thread, one call at a time. Every call may fail with: Disconnected;
/// Timeout when the master says nothing for long; BadFrame for an answer that is none; the code and
/// the words of the master's own Failure; and Interrupted soon after `stopped` has become true.
/// After Interrupted only `cancel` and the destructor may be called.
class Connection {
  public:
    /// `address` as a user writes it. `stopped` is asked some times a second while a call waits.
    /// `tls`: null is plain. Errors: BadInput for the address; Refused beyond loopback without TLS
    /// or `insecure`, or by the master.
    [[nodiscard]] static Result<std::unique_ptr<Connection>>
    open(const std::string& address,
         bool insecure,
         std::function<bool()> stopped,
         std::shared_ptr<const Tls> tls = nullptr);
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();

    /// Tells of a mesh that travels: at its start, after each piece, and at its end.
    using UploadProgress =
        std::function<void(const NamedMesh&, std::uint64_t bytes, std::uint64_t bytes_total)>;
    /// Sends those that the master does not have, each once, and waits until it has stored them.
    /// Errors: Incomplete naming a mesh that the master has no room for.
    [[nodiscard]] Status upload(std::span<const NamedMesh> meshes, const UploadProgress& progress);

    /// A job that is whole in its description (`submit.grid` is set).
    [[nodiscard]] Result<JobId> submit(const Submit& submit);
    /// Submits a job and its poses, read in runs, with labels for all of them or none. Sets
    /// `submit.scenarios` and `submit.poses.labels`. Errors: also those of
    /// `poses`.
    [[nodiscard]] Result<JobId>
    submit(Submit submit, PoseSource& poses, const PoseLabels& labels = {});

    /// Until the job has ended. Calls `changed` with each status, the last one included, and where
    /// it is given `looked` with the cluster, once in a while and more often where the job stands
    /// still.
    [[nodiscard]] Result<JobStatus>
    watch(JobId job,
          const std::function<void(const JobStatus&)>& changed,
          const std::function<void(const ClusterStatus&)>& looked = {});

    /// Of a job that is done. Errors: NotFound; Refused.
    [[nodiscard]] Result<ContactMapAnswer> contact_map(JobId job);

    /// The results that there are of scenarios [first, first + count), in order, pulled in runs.
    /// Scenarios without a result are passed over. An error of `take` ends it.
    [[nodiscard]] Status fetch(JobId job,
                               std::uint64_t first,
                               std::uint64_t count,
                               const std::function<Status(const ScenarioResult&)>& take);

    /// A job as it was submitted. Errors: NotFound.
    [[nodiscard]] Result<JobDescription> job_description(JobId job);
    /// A mesh of the master's, checked against its hash. Errors: NotFound; TooLarge.
    [[nodiscard]] Result<Mesh> fetch_mesh(const Sha256& mesh);
    /// The poses of scenarios [first, first + count), which the job has, with their labels. Keeps
    /// them in memory: whoever needs many asks for them in runs. Errors: NotFound; BadInput.
    [[nodiscard]] Result<FetchedPoses>
    fetch_poses(JobId job, std::uint64_t first, std::uint64_t count);

    /// The owner of jobs submitted on this connection, as told by the master.
    [[nodiscard]] const std::string& owner() const;
    [[nodiscard]] Result<ClusterStatus> status();
    /// Ends the job; of one that has ended, nothing. The status after it.
    [[nodiscard]] Result<JobStatus> cancel(JobId job);
    /// Removes a job, and its meshes if no other job uses them. Errors: NotFound; Refused unless
    /// the user owns it, or while it runs and `cancel` is not set.
    [[nodiscard]] Result<Removed> remove_job(JobId job, bool cancel);
    /// Removes a mesh. Errors: NotFound; Refused unless the user is an admin, or while a job uses
    /// it.
    [[nodiscard]] Result<Removed> remove_mesh(const Sha256& mesh);
    /// Drains workers. Errors: NotFound; Refused unless the user is an admin.
    [[nodiscard]] Result<Draining> drain(const DrainWorkers& wish);
    /// One scenario fails, and the job goes on. Errors: NotFound; Refused when it has a result.
    [[nodiscard]] Result<JobStatus> cancel_scenario(JobId job, std::uint64_t scenario);
    /// How the workers score for a scenario of a running job.
    [[nodiscard]] Result<Explained> explain(JobId job, std::uint64_t scenario);
    /// A token with which others join. Errors: Refused to who is no admin.
    [[nodiscard]] Result<TokenCreated> create_token(const TokenCreate& terms);
    /// Waits, with an ear for interrupts.
    [[nodiscard]] Status pause(std::chrono::milliseconds time);

  private:
    struct State;
    explicit Connection(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
