// The page of the master.
#pragma once

#include "common/core/host/thread_pool.hpp"
#include "master/identity/access.hpp"
#include "master/page/coordinator_reader.hpp"
#include "proto/channel/http/http.hpp"
#include "web/server/cluster/cluster_source.hpp"
#include "web/server/page_server.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Runs on the coordinator's thread. Reads jobs on a thread of its own, files on the blocking pool,
/// and runs scenarios on the compute pool.
class MasterPage {
  public:
    /// The coordinator outlives the page. `host_names`: further names in the header Host.
    MasterPage(Coordinator& coordinator, std::vector<std::string> host_names, bool is_tls);

    void start() { source_.start(); }
    void close() { source_.close(); }

    [[nodiscard]] bool is_own_host(std::string_view host) const {
        return server_.is_own_host(host);
    }
    /// Reads the cluster as the page does.
    [[nodiscard]] CoordinatorReader& reader() { return reader_; }
    /// Answers any request, if `access` allows it.
    void answer(const HttpRequest& request, const Access& access, HttpRespond respond);

  private:
    CoordinatorReader reader_;
    ThreadPool reading_{1};
    ClusterSource source_;
    PageServer server_;
};

} // namespace cd
