#include "client/remote/credential_renewal.hpp"

#include "client/remote/membership.hpp"
#include "common/core/timing/wire.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace cd {

CredentialRenewal::CredentialRenewal(MasterOptions options, Endpoint master)
    : options_(std::move(options)), master_(std::move(master)) {
    if (renewal_time(options_, master_)) {
        thread_ = std::jthread([this](const std::stop_token& stop) { keep(stop); });
    }
}

CredentialRenewal::~CredentialRenewal() = default;

void CredentialRenewal::keep(const std::stop_token& stop) {
    auto due = renewal_time(options_, master_);
    while (due) {
        const auto pause =
            std::clamp<std::chrono::system_clock::duration>(*due - std::chrono::system_clock::now(),
                                                            timing::renewal_retry_min,
                                                            timing::renewal_check_period);
        std::unique_lock lock(mutex_);
        if (stopped_.wait_for(lock, stop, pause, [&] { return stop.stop_requested(); })) {
            return;
        }
        if (std::chrono::system_clock::now() < *due) {
            continue;
        }
        const auto renewed = client_tls(options_, master_, stop);
        const auto next = renewal_time(options_, master_);
        count_ += renewed && next && *next > *due ? 1 : 0;
        due = next;
    }
}

} // namespace cd
