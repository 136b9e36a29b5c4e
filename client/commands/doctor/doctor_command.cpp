// The verb that looks for what is wrong here and with a cluster.
#include "client/base/exit_code.hpp"
#include "client/base/interrupt.hpp"
#include "client/commands/commands.hpp"
#include "client/commands/doctor/cluster_checks.hpp"
#include "client/commands/doctor/finding.hpp"
#include "client/commands/doctor/own_checks.hpp"
#include "client/commands/remote_session.hpp"
#include "client/remote/membership.hpp"
#include "client/trees/tree_cache.hpp"
#include "common/core/errors.hpp"
#include "common/core/timing/client.hpp"
#include "common/geometry/simd_target.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

namespace cd {

namespace {

using Wall = std::chrono::system_clock;

constexpr const char* no_http = "none";
constexpr std::uint16_t usual_http_port = 7680;

MachineFacts this_machine_facts() {
    return {check_simd_environment(),
            std::string(to_text(simd_target())),
            std::max(1u, std::thread::hardware_concurrency()),
            free_memory()};
}

/// Returns the time in the middle between `begin` and now, to which an answer is dated.
Wall::time_point middle_since(Wall::time_point begin) {
    return begin + (Wall::now() - begin) / 2;
}

/// Reads the master's HTTP port into `facts`, or why it cannot be read.
Status read_http(const DoctorCommand& command, const Endpoint& master, ClusterFacts& facts) {
    if (command.http == no_http) {
        facts.no_metrics = "--http none";
        return Done{};
    }
    const bool is_named = !command.http.empty();
    const Endpoint http = is_named ? CD_TRY(within("--http: ", parse_endpoint(command.http)))
                                   : Endpoint{master.host, usual_http_port};
    const auto tls = CD_TRY(client_tls(command.master, master));
    const Wall::time_point begin = Wall::now();
    auto metrics = read_metrics(http, tls, timing::doctor_http_max);
    facts.metrics_time = middle_since(begin);
    const std::string name = http.host + ":" + std::to_string(http.port);
    if (metrics && is_of_master(metrics.value(), facts.status)) {
        facts.metrics = std::move(metrics.value());
        return Done{};
    }
    const std::string why = metrics ? "it is another master's" : metrics.error().detail;
    if (is_named) {
        return Error{ErrorCode::Disconnected, "--http " + name + ": " + why};
    }
    facts.no_metrics = "--http names the master's HTTP port (none at " + name + ")";
    return Done{};
}

/// Looks at the cluster. An error ends the look, and is a fault of the master.
Status look_at_cluster(const DoctorCommand& command,
                       const Endpoint& master,
                       const std::string& role,
                       std::vector<Finding>& findings) {
    ClusterFacts facts;
    const auto connection = CD_TRY(open_master(command.master));
    const Wall::time_point begin = Wall::now();
    facts.status = CD_TRY(connection->status());
    facts.status_time = middle_since(begin);
    facts.address = command.master.address;
    facts.owner = connection->owner();
    facts.role = connection->is_tls() ? role : "";
    facts.is_tls = connection->is_tls();
    facts.is_loopback = is_loopback(master);
    const Status http = read_http(command, master, facts);
    findings.push_back(master_finding(facts));
    if (!http) {
        findings.push_back({Finding::Grade::Fail, "master's HTTP", http.error().detail});
        facts.no_metrics = "see above";
    }
    for (auto& found : {worker_findings(facts), job_findings(facts)}) {
        findings.insert(findings.end(), found.begin(), found.end());
    }
    findings.push_back(disk_finding(facts));
    return Done{};
}

} // namespace

Result<int> perform(const DoctorCommand& command) {
    const InterruptGuard interrupts;
    const Endpoint master = CD_TRY(parse_endpoint(command.master.address));
    std::vector<Finding> findings;
    findings.push_back(machine_finding(this_machine_facts()));
    findings.push_back(tree_cache_finding(tree_cache_folder(command.tree_cache)));
    const auto identity = own_identity(command.master, master);
    findings.push_back(credential_finding(identity, Wall::now()));
    const std::string role =
        identity && identity.value() ? std::string(to_text(identity.value()->role)) : std::string();
    const Status looked = look_at_cluster(command, master, role, findings);
    if (!looked && looked.error().code == ErrorCode::Interrupted) {
        return looked.error();
    }
    if (!looked) {
        findings.push_back({Finding::Grade::Fail, "master", looked.error().detail});
    }
    const std::string text =
        command.output == "json" ? findings_json(findings) : findings_text(findings);
    std::fputs(text.c_str(), stdout);
    const bool has_failed =
        std::ranges::find(findings, Finding::Grade::Fail, &Finding::grade) != findings.end();
    return has_failed ? exit_contacts : exit_done;
}

} // namespace cd
