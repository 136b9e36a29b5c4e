// The master's identity: its certificate authority, its own certificate, and its join tokens.
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

/// Keeps its files in the folder `identity` of the state directory, which only its owner may read.
/// Not thread-safe.
class MasterIdentity {
  public:
    using Clock = std::function<WallTime()>;

    struct Options {
        /// Validity of the certificates that the master signs for others.
        std::chrono::seconds certificate_life;
        Clock now = [] { return std::chrono::system_clock::now(); };
    };

    /// Creates an identity if there is none, whole or not at all. Otherwise writes a new admin
    /// credential. Errors: Io; BadInput for damaged files.
    [[nodiscard]] static Status init(const std::filesystem::path& state, const Options& options);

    /// Opens the identity, and renews certificates that are due. Returns null if `init` has not
    /// run. Errors: Io; BadInput for damaged files; Refused for files that others may read.
    [[nodiscard]] static Result<std::unique_ptr<MasterIdentity>>
    open(const std::filesystem::path& state, const Options& options);

    /// Checks that the identity's files, if any, can be read, whoever owns them; changes nothing.
    /// Errors: as `open`.
    [[nodiscard]] static Status check(const std::filesystem::path& state);

    /// The master's current TLS context, which a renewal replaces.
    [[nodiscard]] std::shared_ptr<const TlsSlot> tls() const { return tls_; }
    [[nodiscard]] Sha256 fingerprint() const { return authority_.fingerprint(); }
    /// Path of the admin credential that `init` creates.
    [[nodiscard]] static std::filesystem::path admin_path(const std::filesystem::path& state);

    [[nodiscard]] WallTime now() const { return options_.now(); }
    /// Checks that the file `refused` in the state directory, with one name a line, does not list
    /// this holder. Reads the file each time. Errors: Refused, also if the file is unreadable.
    [[nodiscard]] Status check_refused(const std::string& name) const;

    /// Renews the master's own certificate and the admin's when due. Errors: Io.
    [[nodiscard]] Status keep_valid();

    /// Issues a certificate for a join token, and writes the use of the token to the disk before it
    /// returns. `binding`: TLS channel binding of the connection. Errors: Refused with the reason;
    /// BadInput; Io.
    [[nodiscard]] Result<Certified> join(const Join& message, const Sha256& binding);
    /// Issues a new certificate to `holder`, who showed a valid one. Errors: Refused; BadInput.
    [[nodiscard]] Result<Certified> renew(const Renew& message, const Identity& holder) const;
    /// Creates a join token, and writes it to the disk. Errors: as `TokenBook::create`; Io.
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
