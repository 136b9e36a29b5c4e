#include "client/commands/viewing.hpp"

#include "client/base/interrupt.hpp"
#include "client/commands/remote_session.hpp"
#include "client/remote/membership.hpp"
#include "client/trees/tree_cache.hpp"
#include "client/view/remote_reader.hpp"
#include "common/core/timing/web.hpp"
#include "common/core/version.hpp"
#include "web/server/cluster/cluster_source.hpp"

#include <chrono>
#include <cstdio>
#include <optional>

namespace cd {

namespace {

PageOrigin origin_of(const ClusterViewing& what) {
    PageOrigin origin;
    origin.kind = PageOrigin::Kind::Remote;
    origin.program = "cdctl " + std::string(version);
    origin.name = what.master.address;
    origin.is_tls = what.is_tls;
    origin.job = what.job;
    return origin;
}

} // namespace

void serve_page(PageGateway& gateway, PageSource& source, const Serving& how) {
    std::printf("%s\n", gateway.url().c_str());
    std::fflush(stdout);
    std::fprintf(stderr,
                 "  Ctrl-C ends it%s\n",
                 how.ends_idle ? ", and so do 30 minutes without a request" : "");
    if (!how.no_browser) {
        open_browser(gateway.url());
    }
    const auto idle_max = how.ends_idle
                              ? std::optional<std::chrono::milliseconds>(timing::view_idle_max)
                              : std::nullopt;
    gateway.serve(source, &InterruptGuard::has_come, idle_max);
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
    serve_page(gateway, source, what.serving);
    source.close();
}

} // namespace cd
