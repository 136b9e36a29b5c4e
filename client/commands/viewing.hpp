// Serves the page until the user ends it.
#pragma once

#include "client/cli/cli.hpp"
#include "client/view/page_gateway.hpp"
#include "web/server/page_source.hpp"

#include <string>

namespace cd {

struct Serving {
    bool no_browser = false; ///< Prints the address only.
    bool ends_idle = true;   ///< Ends `timing::view_idle_max` after the last request.
};

/// Prints the page's address, opens it in the browser, and serves the source until a signal comes.
/// Needs an `InterruptGuard`.
void serve_page(PageGateway& gateway, PageSource& source, const Serving& how);

/// What `view_cluster` shows.
struct ClusterViewing {
    MasterOptions master;
    std::string job;        ///< Id of the only job; empty: the cluster.
    std::string tree_cache; ///< As of --tree-cache.
    unsigned threads = 0;   ///< Threads that build trees.
    bool is_tls = false;    ///< The connection to the master is encrypted.
    Serving serving{};
};

/// Serves the page of a master's job, or of the master's cluster, as `serve_page` does.
void view_cluster(PageGateway& gateway, const ClusterViewing& what);

} // namespace cd
