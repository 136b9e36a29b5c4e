#include "master/run_master.hpp"

#include "common/core/files/state_folder.hpp"
#include "common/core/host/log.hpp"
#include "common/core/host/service_notice.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/host/wall_clock.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/wire.hpp"
#include "master/base/file_locks.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/identity/identity.hpp"
#include "master/net/http_front.hpp"
#include "master/net/server.hpp"
#include "proto/channel/signals.hpp"

#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace cd {

namespace {

/// Writes the port file atomically, because a script may be waiting for it.
Status write_port(const std::string& path, std::uint16_t port) {
    const std::string unfinished = path + ".new";
    std::ofstream file(unfinished);
    file << port << '\n';
    file.close();
    std::error_code error;
    if (file) {
        std::filesystem::rename(unfinished, path, error);
    }
    if (!file || error) {
        return Error{ErrorCode::Io, "cannot write the port to '" + path + "'"};
    }
    return Done{};
}

/// Raises the descriptor limit: each connection and each job's results need a file.
void allow_many_files() {
    rlimit files{};
    if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
        files.rlim_cur = files.rlim_max;
        (void)setrlimit(RLIMIT_NOFILE, &files); // If that fails, the limit allows fewer jobs.
    }
}

/// Forgets jobs whose retention has expired, every `timing::retention_check_period`.
asio::awaitable<void>
keep_jobs(Coordinator& coordinator, asio::steady_timer& pause, const bool& stopping) {
    while (!stopping) {
        coordinator.jobs().forget_expired(unix_seconds());
        pause.expires_after(timing::retention_check_period);
        boost::system::error_code ignored;
        co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
}

/// Renews the master's and the admin's certificates before they expire.
asio::awaitable<void>
keep_valid(MasterIdentity& identity, asio::steady_timer& pause, const bool& stopping) {
    while (!stopping) {
        pause.expires_after(timing::renewal_check_period);
        boost::system::error_code ignored;
        co_await pause.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        if (const Status valid = identity.keep_valid(); !valid) {
            log_error("certificate not renewed: error=\"{}\"", valid.error().detail);
        }
    }
}

/// Opens the HTTP port. Returns null if the configuration has no HTTP endpoint.
Result<std::unique_ptr<HttpFront>>
listen_http(const MasterConfig& config, Coordinator& coordinator, MasterIdentity* identity) {
    if (!config.http.listen) {
        return std::unique_ptr<HttpFront>();
    }
    const Exposure exposure{identity != nullptr, config.insecure, true};
    if (Status exposed = check_exposure(*config.http.listen, exposure); !exposed) {
        return exposed.error();
    }
    return HttpFront::listen(coordinator.parts().executor,
                             *config.http.listen,
                             coordinator,
                             identity,
                             config.http.names);
}

} // namespace

Status init_master(const MasterConfig& config) {
    if (Status made = make_private_folder(config.state); !made) {
        return made;
    }
    const MasterIdentity::Options options{config.certificate_life};
    if (Status made = MasterIdentity::init(config.state, options); !made) {
        return made;
    }
    const auto identity = MasterIdentity::open(config.state, options);
    if (!identity) {
        return identity.error();
    }
    const std::string admin = MasterIdentity::admin_path(config.state).string();
    std::printf("identity    %s\n"
                "authority   %s\n"
                "admin       %s\n"
                "Start cdmaster with this state, and let others in:\n"
                "  cdctl token create --role worker --uses 50 --credential %s\n",
                (config.state / "identity").c_str(),
                to_hex(identity.value()->fingerprint()).c_str(),
                admin.c_str(),
                admin.c_str());
    return Done{};
}

Status run_master(const MasterConfig& config) {
    if (Status made = make_private_folder(config.state); !made) {
        return made;
    }
    if (Status has_locks = check_file_locks(config.state); !has_locks) {
        return has_locks;
    }
    const auto identity = MasterIdentity::open(config.state, {config.certificate_life});
    if (!identity) {
        return identity.error();
    }
    const bool secured = identity.value() != nullptr;
    if (Status exposed = check_exposure(config.listen, {secured, config.insecure, true});
        !exposed) {
        return exposed;
    }
    // A write beyond the file size limit must be an error, which is retried, and not a signal that
    // kills the master.
    std::signal(SIGXFSZ, SIG_IGN);
    allow_many_files();
    // The context is destroyed last, because functions on the pools may post to it.
    asio::io_context context(1);
    AsioLoop loop(context.get_executor());
    ThreadPool compute(config.threads);
    const auto store = GeometryStore::open(config.state, compute);
    if (!store) {
        return store.error();
    }
    StoredGeometry geometry(*store.value());
    auto journal = Journal::open({config.state, !config.no_sync});
    if (!journal) {
        return journal.error();
    }
    ThreadPool blocking(limits::blocking_threads);
    Coordinator coordinator(
        {context.get_executor(),
         loop,
         tcp_network(),
         geometry,
         store.value().get(),
         compute,
         blocking,
         *journal.value(),
         config.state / "jobs",
         {.durability = config.no_sync ? Durability::Unsynced : Durability::Synced,
          .times = config.times,
          .retention = config.retention}});
    if (Status restored = coordinator.restore(journal.value()->take_recovered()); !restored) {
        return restored;
    }
    const auto server =
        Server::listen(context.get_executor(), config.listen, coordinator, identity.value().get());
    if (!server) {
        return server.error();
    }
    const std::uint16_t port = server.value()->port();
    const auto http = listen_http(config, coordinator, identity.value().get());
    if (!http) {
        return http.error();
    }
    bool stopping = false;
    asio::steady_timer renewal(context);
    asio::steady_timer retention(context);
    spawn(context.get_executor(), "retention", keep_jobs(coordinator, retention, stopping));
    if (secured) {
        spawn(context.get_executor(), "renewal", keep_valid(*identity.value(), renewal, stopping));
    }
    StopSignals signals(context.get_executor(), [&](unsigned) {
        notify_service("STOPPING=1");
        stopping = true;
        renewal.cancel();
        retention.cancel();
        server.value()->close();
        if (http.value() != nullptr) {
            http.value()->close();
        }
        signals.cancel();
    });
    server.value()->start();
    if (http.value() != nullptr) {
        http.value()->start();
        log_info("http listening: host={} port={}", config.http.listen->host, http.value()->port());
    }
    log_info("listening: host={} port={} state={} tls={}",
             config.listen.host,
             port,
             std::filesystem::absolute(config.state).string(),
             secured);
    // Written after the signal handler is set and the ports are logged: a script that waits for the
    // file may at once send a signal, or look for the HTTP port in the log.
    if (!config.port_file.empty()) {
        if (Status written = write_port(config.port_file, port); !written) {
            return written;
        }
    }
    std::printf("%s\n", join_line({config.listen.host, port}, secured).c_str());
    std::fflush(stdout);
    notify_service("READY=1");

    while (!stopping) {
        context.run_one();
    }
    // Lets sessions end and functions on the pools return, for at most `stop_grace`.
    context.run_for(timing::stop_grace);
    log_info("ended");
    return Done{};
}

} // namespace cd
