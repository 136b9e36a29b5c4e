#include "worker/membership/credential_keeper.hpp"

#include "common/core/host/log.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/access/join.hpp"

#include <algorithm>
#include <utility>

namespace cd {

namespace {

using Milliseconds = std::chrono::milliseconds;

Milliseconds time_until(WallTime time) {
    return std::chrono::duration_cast<Milliseconds>(time - std::chrono::system_clock::now());
}

} // namespace

Result<std::unique_ptr<CredentialKeeper>> CredentialKeeper::open(
    const asio::any_io_executor& executor, std::filesystem::path path, Endpoint master) {
    std::unique_ptr<CredentialKeeper> keeper(
        new CredentialKeeper(executor, std::move(path), std::move(master)));
    const Status loaded = keeper->load();
    if (!loaded && loaded.error().code != ErrorCode::NotFound) {
        return loaded.error();
    }
    return keeper;
}

CredentialKeeper::CredentialKeeper(const asio::any_io_executor& executor,
                                   std::filesystem::path path,
                                   Endpoint master)
    : path_(std::move(path)), master_(std::move(master)), pause_(executor) {}

Status CredentialKeeper::load() {
    const Result<Credential> credential = read_credential(path_);
    if (!credential) {
        return credential.error();
    }
    auto tls = Tls::make(credential.value());
    if (!tls) {
        return Error{tls.error().code, path_.string() + " holds " + tls.error().detail};
    }
    tls_->now = std::move(tls.value());
    return Done{};
}

bool CredentialKeeper::is_due() const {
    return renew_at(*tls_->now->identity()) <= std::chrono::system_clock::now();
}

asio::awaitable<void> CredentialKeeper::keep() {
    Milliseconds pause{0};
    while (!stopped_ && is_secured()) {
        const Milliseconds due = time_until(renew_at(*tls_->now->identity()));
        // Checks periodically, because the clock may be set and the host may sleep.
        pause_.expires_after(std::clamp<Milliseconds>(
            due, std::max(pause, Milliseconds(1)), timing::renewal_check_period));
        boost::system::error_code ignored;
        co_await pause_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        pause = Milliseconds(0);
        if (stopped_ || !is_due()) {
            continue;
        }
        const Status renewed = co_await renew();
        if (!renewed) {
            log_warning("certificate not renewed: error=\"{}\"", renewed.error().detail);
            pause = pause_after_failure();
        }
    }
}

asio::awaitable<Status> CredentialKeeper::renew() {
    // Another worker on this host may have renewed the file.
    const Status loaded = load();
    if (loaded && !is_due()) {
        co_return Done{};
    }
    Endpoint master = master_;
    std::shared_ptr<const Tls> tls = tls_->now;
    const Result<Credential> credential =
        co_await renew_credential(std::move(master), std::move(tls));
    if (!credential) {
        co_return credential.error();
    }
    const Status written = write_credential(path_, credential.value());
    if (!written) {
        co_return written;
    }
    const Status loaded_again = load();
    if (loaded_again) {
        log_info("certificate renewed: seconds={}",
                 time_until(tls_->now->identity()->until).count() / 1000);
    }
    co_return loaded_again;
}

/// Returns an eighth of the remaining validity, so that several attempts fit before the expiry.
Milliseconds CredentialKeeper::pause_after_failure() const {
    const Milliseconds left = time_until(tls_->now->identity()->until);
    return std::clamp<Milliseconds>(
        left / 8, timing::renewal_retry_min, timing::renewal_check_period);
}

void CredentialKeeper::stop() {
    stopped_ = true;
    pause_.cancel();
}

} // namespace cd
