// Renews a user's credential during a long command.
#pragma once

#include "client/cli/cli.hpp"
#include "proto/channel/channel.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>

namespace cd {

/// A thread that renews a user's credential for a master, in the credential's file, each time that
/// half of its lifetime has passed. Without a credential there is no thread.
class CredentialRenewal {
  public:
    CredentialRenewal(MasterOptions options, Endpoint master);
    CredentialRenewal(const CredentialRenewal&) = delete;
    CredentialRenewal& operator=(const CredentialRenewal&) = delete;
    ~CredentialRenewal();

    /// Returns the number of renewals so far.
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
