// Who the master is, and whom it lets in: its authority, its own certificate, its tokens.
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

/// All of it stands in the folder `identity` of the state directory, for its owner alone. One
/// thread.
class MasterIdentity {
  public:
    using Clock = std::function<WallTime()>;

    struct Options {
        std::chrono::seconds certificate_life; ///< Of those that it signs for others.
        Clock now = [] { return std::chrono::system_clock::now(); };
    };

    /// Makes an authority where there is none, and a new credential for an admin. Errors: Io;
    /// BadInput for files that are damaged.
    [[nodiscard]] static Status init(const std::filesystem::path& state, const Options& options);

    /// Null where `init` has not been. Errors: Io; BadInput; Refused for files that others may
    /// read.
    [[nodiscard]] static Result<std::unique_ptr<MasterIdentity>>
    open(const std::filesystem::path& state, const Options& options);

    /// Whether the files of an identity, where there are any, can be read; changes nothing. Errors:
    /// those of `open`.
    [[nodiscard]] static Status check(const std::filesystem::path& state);

    /// With which the master listens.
    [[nodiscard]] std::shared_ptr<const TlsSlot> tls() const { return tls_; }
    [[nodiscard]] Sha256 fingerprint() const { return authority_.fingerprint(); }
    /// Where the credential is that `init` has made.
    [[nodiscard]] static std::filesystem::path admin_path(const std::filesystem::path& state);

    [[nodiscard]] WallTime now() const { return options_.now(); }
    /// Whether the list `refused` in the state directory, one name in a line, names this holder; it
    /// is read each time. Errors: Refused, also where there is a list that cannot be read.
    [[nodiscard]] Status check_refused(const std::string& name) const;

    /// A new certificate of its own, and one for the admin's file, where it is time. Errors: Io.
    [[nodiscard]] Status keep_valid();

    /// `binding` is that of the connection. A use is on the disk before the answer. Errors: Refused
    /// with the reason; BadInput; Io.
    [[nodiscard]] Result<Certified> join(const Join& message, const Sha256& binding);
    /// Another certificate for who has this one.
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
