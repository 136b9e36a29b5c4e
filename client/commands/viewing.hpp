// Serves the page until the user ends it.
#pragma once

#include "client/cli/cli.hpp"
#include "client/view/page_gateway.hpp"
#include "web/server/page_source.hpp"

#include <string>

namespace cd {

/// Prints the page's address, opens it in the browser unless `no_browser` is set, and serves the
/// source until a signal comes or nobody has asked for `timing::view_idle_max`. Needs an
/// `InterruptGuard`.
void serve_page(PageGateway& gateway, PageSource& source, bool no_browser);

/// What `view_cluster` shows.
struct ClusterViewing {
    MasterOptions master;
    std::string job;        ///< Id of the only job; empty: the cluster.
    std::string tree_cache; ///< As of --tree-cache.
    unsigned threads = 0;   ///< Threads that build trees.
    bool no_browser = false;
};

/// Serves the page of a master's job, or of the master's cluster, as `serve_page` does.
void view_cluster(PageGateway& gateway, const ClusterViewing& what);

} // namespace cd
