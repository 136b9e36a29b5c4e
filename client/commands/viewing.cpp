#include "client/commands/viewing.hpp"

#include "client/base/interrupt.hpp"
#include "client/commands/remote_session.hpp"
#include "client/remote/membership.hpp"
#include "client/trees/tree_cache.hpp"
#include "client/view/remote_reader.hpp"
#include "common/core/timing/web.hpp"
#include "common/core/version.hpp"
#include "web/server/cluster/cluster_source.hpp"

#include <cstdio>

namespace cd {

namespace {

PageOrigin origin_of(const ClusterViewing& what) {
    PageOrigin origin;
    origin.kind = PageOrigin::Kind::Remote;
    origin.program = "cdctl " + std::string(version);
    origin.name = what.master.address;
    origin.job = what.job;
    return origin;
}

} // namespace

void serve_page(PageGateway& gateway, PageSource& source, bool no_browser) {
    std::printf("%s\n", gateway.url().c_str());
    std::fflush(stdout);
    std::fprintf(stderr, "  Ctrl-C ends it, and so do 30 minutes without a request\n");
    if (!no_browser) {
        open_browser(gateway.url());
    }
    gateway.serve(source, &InterruptGuard::has_come, timing::view_idle_max);
}

void view_cluster(PageGateway& gateway, const ClusterViewing& what) {
    RemoteReader reader(
        gateway.executor(),
        [&what] { return open_master(what.master); },
        tree_cache_folder(what.tree_cache),
        what.threads);
    ThreadPool running(1);
    ClusterSource source({gateway.executor(),
                          reader,
                          reader.pool(),
                          running,
                          timing::view_run_max,
                          &InterruptGuard::has_come},
                         origin_of(what));
    source.start();
    serve_page(gateway, source, what.no_browser);
    source.close();
}

} // namespace cd
