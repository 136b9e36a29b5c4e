// Keeps a user's credential good while a verb waits for long.
#pragma once

#include "client/cli.hpp"
#include "proto/channel.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>

namespace cd {

/// Renews the credential for a master, and its file, each time it has lived half of its time, on a
/// thread of its own. Does nothing without a credential.
class CredentialRenewal {
  public:
    CredentialRenewal(MasterOptions options, Endpoint master);
    CredentialRenewal(const CredentialRenewal&) = delete;
    CredentialRenewal& operator=(const CredentialRenewal&) = delete;
    ~CredentialRenewal();

    /// How often it has been renewed.
    [[nodiscard]] std::uint64_t count() const { return count_; }

  private:
    void keep(const std::stop_token& stop);

    MasterOptions options_;
    Endpoint master_;
    std::atomic<std::uint64_t> count_ = 0;
    std::mutex mutex_;
    std::condition_variable_any stopped_;
    std::jthread thread_;
};

} // namespace cd
