// The master's authority, its own certificate, and its join tokens.
#pragma once

#include "common/core/result.hpp"
#include "master/identity/token_book.hpp"
#include "proto/channel/tls.hpp"
#include "proto/messages/identity_messages.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace cd {

/// Files lie in the folder `identity` of the state directory, readable by its owner only. One
/// thread.
class MasterIdentity {
  public:
    using Clock = std::function<WallTime()>;

    struct Options {
        /// Validity of the certificates that the master signs for others.
        std::chrono::seconds certificate_life;
        Clock now = [] { return std::chrono::system_clock::now(); };
    };

    /// Creates an authority if there is none, and a new admin credential. Errors: Io; BadInput for
    /// damaged files.
    [[nodiscard]] static Status init(const std::filesystem::path& state, const Options& options);

    /// Returns null if `init` has not run. Errors: Io; BadInput; Refused for files that others may
    /// read.
    [[nodiscard]] static Result<std::unique_ptr<MasterIdentity>>
    open(const std::filesystem::path& state, const Options& options);

    /// Checks that the identity's files, if any, can be read; changes nothing. Errors: those of
    /// `open`.
    [[nodiscard]] static Status check(const std::filesystem::path& state);

    /// The TLS context with which the master listens.
    [[nodiscard]] std::shared_ptr<const TlsSlot> tls() const { return tls_; }
    [[nodiscard]] Sha256 fingerprint() const { return authority_.fingerprint(); }
    /// Path of the admin credential that `init` creates.
    [[nodiscard]] static std::filesystem::path admin_path(const std::filesystem::path& state);

    [[nodiscard]] WallTime now() const { return options_.now(); }
    /// Checks that the list `refused` in the state directory (one name a line) does not name this
    /// holder. Reads the list each time. Errors: Refused, also for an unreadable list.
    [[nodiscard]] Status check_refused(const std::string& name) const;

    /// Renews the master's own certificate and the admin's when due. Errors: Io.
    [[nodiscard]] Status keep_valid();

    /// `binding` is that of the connection. The token's use is on disk before this returns. Errors:
    /// Refused with the reason; BadInput; Io.
    [[nodiscard]] Result<Certified> join(const Join& message, const Sha256& binding);
    /// Issues a new certificate to the holder of a valid one.
    [[nodiscard]] Result<Certified> renew(const Renew& message, const Identity& holder) const;
    [[nodiscard]] Result<TokenCreated> create_token(const TokenCreate& message);

  private:
    MasterIdentity(std::filesystem::path folder,
                   CertificateAuthority authority,
                   TokenBook tokens,
                   Options options);

    [[nodiscard]] Identity
    identity_from_now(CertifiedRole role, const std::string& name, std::chrono::seconds life) const;
    [[nodiscard]] Result<Certified>
    certify(const std::string& request, CertifiedRole role, const std::string& name) const;
    [[nodiscard]] Status save_tokens() const;
    void renew_own();
    [[nodiscard]] Status renew_admin() const;

    std::filesystem::path folder_;
    CertificateAuthority authority_;
    TokenBook tokens_;
    Options options_;
    std::shared_ptr<TlsSlot> tls_ = std::make_shared<TlsSlot>();
};

} // namespace cd
