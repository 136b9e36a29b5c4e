// A client's connection to a master, with blocking calls.
#pragma once

#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/poses/labelled_scenarios.hpp"
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

/// A mesh that a job needs, and its name in messages to the user.
struct NamedMesh {
    std::string name;
    std::shared_ptr<const Mesh> mesh;
};

/// A connection for use by one thread. Every call blocks and may fail with: Disconnected; Timeout
/// when the master is silent for long; BadFrame for an invalid answer; the code and text of a
/// Failure from the master; and Interrupted soon after `stopped` returns true. After Interrupted
/// only `cancel` and the destructor may be called.
class Connection {
  public:
    /// Connects to `address`, HOST:PORT. Calls that wait poll `stopped` a few times a second. A
    /// null `tls` connects in plain text. Errors: BadInput for the address; Refused by the master,
    /// or beyond loopback without TLS and without `insecure`.
    [[nodiscard]] static Result<std::unique_ptr<Connection>>
    open(const std::string& address,
         bool insecure,
         std::function<bool()> stopped,
         std::shared_ptr<const Tls> tls = nullptr);
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection();

    /// Is called during the upload of a mesh: at its start, after each piece, and at its end.
    using UploadProgress =
        std::function<void(const NamedMesh&, std::uint64_t bytes, std::uint64_t bytes_total)>;
    /// Uploads each mesh that the master lacks, once, and waits until the master has stored it.
    /// Errors: Incomplete naming a mesh for which the master has no room.
    [[nodiscard]] Status upload(std::span<const NamedMesh> meshes, const UploadProgress& progress);

    /// Submits a job whose poses are a grid (`submit.grid` is set).
    [[nodiscard]] Result<JobId> submit(const Submit& submit);
    /// Submits a job and its poses, a few thousand scenarios at a time. Either all poses have
    /// labels or none has. Sets `submit.scenarios` and `submit.poses.labels`. Errors: Incomplete if
    /// the master has no room for the poses; the errors of reading `poses`.
    [[nodiscard]] Result<JobId>
    submit(Submit submit, PoseSource& poses, const PoseLabels& labels = {});

    /// Waits until the job has ended. Calls `changed` with each status of the job, including the
    /// last. Calls `looked`, if set, with the cluster's status: now and then, and more often while
    /// the job makes no progress.
    [[nodiscard]] Result<JobStatus>
    watch(JobId job,
          const std::function<void(const JobStatus&)>& changed,
          const std::function<void(const ClusterStatus&)>& looked = {});

    /// Fetches the contact map of a completed job, or the sums by part of any job. Errors:
    /// NotFound; Refused.
    [[nodiscard]] Result<ContactMapAnswer> contact_map(const ContactMapQuery& query);

    /// Passes the results of scenarios [first, first + count) to `take`, in the order of their
    /// indices. Skips scenarios without a result. An error of `take` ends the fetch.
    [[nodiscard]] Status fetch(JobId job,
                               std::uint64_t first,
                               std::uint64_t count,
                               const std::function<Status(const ScenarioResult&)>& take);
    /// As the overload above, for a query that may have a sample; passes also each result's place.
    /// `scenarios` is the job's number of them.
    [[nodiscard]] Status
    fetch(const ResultsQuery& query,
          std::uint64_t scenarios,
          const std::function<Status(std::uint64_t place, const ScenarioResult&)>& take);

    /// Fetches the description with which a job was submitted. Errors: NotFound.
    [[nodiscard]] Result<JobDescription> job_description(JobId job);
    /// Fetches a mesh and checks its hash. Errors: NotFound; TooLarge.
    [[nodiscard]] Result<Mesh> fetch_mesh(const Sha256& mesh);
    /// Fetches the poses and labels of scenarios [first, first + count), which must exist, into
    /// memory, so callers that need many fetch them part by part. Errors: NotFound; BadInput.
    [[nodiscard]] Result<LabelledScenarios>
    fetch_poses(JobId job, std::uint64_t first, std::uint64_t count);
    /// As the overload above, for a query that may have a sample. `scenarios` is the job's number
    /// of them.
    [[nodiscard]] Result<LabelledScenarios> fetch_poses(const PosesQuery& query,
                                                        std::uint64_t scenarios);

    /// True if the connection is encrypted.
    [[nodiscard]] bool is_tls() const;
    /// Returns the user to whom the master assigns jobs submitted on this connection.
    [[nodiscard]] const std::string& owner() const;
    [[nodiscard]] Result<ClusterStatus> status();
    /// Cancels a job unless it has ended. Returns its last status.
    [[nodiscard]] Result<JobStatus> cancel(JobId job);
    /// Removes a job, and its meshes if no other job uses them. Errors: NotFound; Refused if the
    /// user does not own the job, or if it runs and `cancel` is not set.
    [[nodiscard]] Result<Removed> remove_job(JobId job, bool cancel);
    /// Removes a mesh. Errors: NotFound; Refused if the user is not an admin, or while a job uses
    /// the mesh.
    [[nodiscard]] Result<Removed> remove_mesh(const Sha256& mesh);
    /// Drains workers. Errors: NotFound; Refused unless the user is an admin.
    [[nodiscard]] Result<Draining> drain(const DrainWorkers& wish);
    /// Makes one scenario fail; its job goes on. Errors: NotFound; Refused if it has a result.
    [[nodiscard]] Result<JobStatus> cancel_scenario(JobId job, std::uint64_t scenario);
    /// Changes the priority of a job. Errors: NotFound; Refused if the job has ended, or the user
    /// may not.
    [[nodiscard]] Result<JobStatus> set_priority(JobId job, std::int32_t priority);
    /// Asks how the master scores each worker for a scenario of a running job.
    [[nodiscard]] Result<Explained> explain(JobId job, std::uint64_t scenario);
    /// Creates a token to join the cluster. Errors: Refused unless the user is an admin.
    [[nodiscard]] Result<TokenCreated> create_token(const TokenCreate& terms);
    /// Sleeps for `time`. Errors: Interrupted.
    [[nodiscard]] Status pause(std::chrono::milliseconds time);

  private:
    struct State;
    explicit Connection(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// True if a new connection may help: the old one broke, was silent, or carried damaged bytes.
[[nodiscard]] bool is_of_the_network(const Error& error);

} // namespace cd
