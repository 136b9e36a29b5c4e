#include "client/commands/remote_session.hpp"

#include "client/remote/credential_renewal.hpp"
#include "client/report/waiting_note.hpp"
#include "common/core/errors.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"
#include "common/core/words.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

namespace cd {

namespace {

/// Returns the error for an argument taken for a job's id, since no folder has this name.
Error no_folder(const std::string& text, const Error& error) {
    const std::string detail = "there is no folder '" + text + "', ";
    switch (error.code) {
    case ErrorCode::Disconnected:
        return {error.code,
                detail + "so it was taken as a job of the master: " + error.detail +
                    " --master names another one"};
    case ErrorCode::NotFound:
        return {error.code, detail + "and " + error.detail};
    default:
        return error;
    }
}

Result<std::unique_ptr<Connection>> open_again(const MasterOptions& master) {
    const auto give_up_at = std::chrono::steady_clock::now() + timing::come_back_max;
    for (;;) {
        auto opened = open_master(master);
        if (opened || !is_of_the_network(opened.error()) ||
            std::chrono::steady_clock::now() > give_up_at) {
            return opened;
        }
        if (InterruptGuard::has_come()) {
            return interrupted();
        }
        std::this_thread::sleep_for(timing::come_back_period);
    }
}

} // namespace

Result<std::unique_ptr<Connection>> open_master_for_job(const MasterOptions& options) {
    auto opened = open_master(options);
    if (!opened && opened.error().code == ErrorCode::Disconnected) {
        return Error{ErrorCode::Disconnected,
                     opened.error().detail + " without --master the job runs here"};
    }
    return opened;
}

Result<ConnectedJob> open_job_of_argument(const MasterOptions& options, const std::string& text) {
    auto opened = open_job(options, text);
    return opened ? std::move(opened) : no_folder(text, opened.error());
}

Result<JobStatus> watch_job(const MasterOptions& master,
                            std::unique_ptr<Connection>& connection,
                            JobId job,
                            const std::string& id,
                            ProgressPrinter::Style progress) {
    ProgressPrinter printer(progress);
    int damaged = 0; // Number of consecutive connections with damaged bytes.
    JobStatus last;
    std::optional<ClusterStatus> cluster;
    const auto print = [&] {
        const WaitingNote note =
            cluster ? waiting_note(last, *cluster, master.address) : WaitingNote();
        const ProgressState state{id, last.summary, last.seconds, note};
        if (last.state == JobState::Running) {
            printer.update(state);
        } else {
            printer.finish(state);
        }
    };
    const auto show = [&](const JobStatus& status) {
        damaged = 0;
        last = status;
        print();
    };
    const auto look = [&](const ClusterStatus& status) {
        cluster = status;
        print();
    };
    const bool tells = progress != ProgressPrinter::Style::Silent;
    const CredentialRenewal renewal(master, parse_endpoint(master.address).value());
    std::uint64_t renewals = renewal.count();
    for (;;) {
        Result<JobStatus> status = connection->watch(
            job, show, tells ? look : std::function<void(const ClusterStatus&)>());
        const bool is_renewed = renewal.count() != renewals; // Since the last connection.
        if (!status && status.error().code == ErrorCode::Refused && is_renewed) {
            renewals = renewal.count();
            connection = CD_TRY(open_again(master));
            continue;
        }
        if (status || !is_of_the_network(status.error())) {
            return status;
        }
        // Gives up on a master that sends nothing but damaged bytes.
        if (status.error().code == ErrorCode::BadFrame &&
            ++damaged >= limits::damaged_connections_max) {
            return status;
        }
        std::fprintf(stderr,
                     "cdctl: the master is gone; waiting for it to come back: %s\n",
                     status.error().detail.c_str());
        std::this_thread::sleep_for(timing::come_back_period);
        connection = CD_TRY(open_again(master));
    }
}

} // namespace cd
