// Renews the certificate that a worker shows to its master and to other workers.
#pragma once

#include "proto/access/credential_file.hpp"
#include "proto/channel/asio.hpp"
#include "proto/channel/endpoint.hpp"
#include "proto/channel/tls.hpp"

#include <filesystem>
#include <memory>

namespace cd {

/// Owns one credential file, which other workers on this host may share. Not thread-safe.
class CredentialKeeper {
  public:
    /// Reads the file at `path`; without a file, the keeper has no certificate. Errors: those of
    /// `read_credential` except NotFound; those of `Tls::make`.
    [[nodiscard]] static Result<std::unique_ptr<CredentialKeeper>>
    open(const asio::any_io_executor& executor, std::filesystem::path path, Endpoint master);

    /// Whether there is a certificate.
    [[nodiscard]] bool is_secured() const { return tls_->now != nullptr; }
    [[nodiscard]] std::shared_ptr<const TlsSlot> tls() const { return tls_; }

    /// Renews each certificate at the time that `renew_at` gives, until `stop`.
    [[nodiscard]] asio::awaitable<void> keep();
    void stop();

  private:
    CredentialKeeper(const asio::any_io_executor& executor,
                     std::filesystem::path path,
                     Endpoint master);

    [[nodiscard]] Status load();
    [[nodiscard]] bool is_due() const;
    [[nodiscard]] std::chrono::milliseconds pause_after_failure() const;
    [[nodiscard]] asio::awaitable<Status> renew();

    std::filesystem::path path_;
    Endpoint master_;
    std::shared_ptr<TlsSlot> tls_ = std::make_shared<TlsSlot>();
    asio::steady_timer pause_;
    bool stopped_ = false;
};

} // namespace cd
