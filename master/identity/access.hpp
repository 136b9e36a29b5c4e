// What one connection may ask of the master, by the certificate that it has shown.
#pragma once

#include "common/core/result.hpp"
#include "proto/codec/message.hpp"
#include "proto/identity/certificate.hpp"

#include <optional>
#include <string>
#include <utility>

namespace cd {

class MasterIdentity;

/// A connection without TLS, which only loopback or --insecure allow, may ask for all that there
/// is.
class Access {
  public:
    Access() = default;
    Access(MasterIdentity& identity, std::optional<Identity> holder)
        : identity_(&identity), holder_(std::move(holder)) {}

    /// Null without TLS.
    [[nodiscard]] MasterIdentity* identity() const { return identity_; }
    /// Empty when the peer showed no certificate.
    [[nodiscard]] const std::optional<Identity>& holder() const { return holder_; }

    /// The owner of the jobs that are submitted here: the certificate's holder or, without TLS, the
    /// user that the client names.
    [[nodiscard]] const std::string& owner() const { return holder_ ? holder_->name : user_; }
    void set_user(std::string user) { user_ = std::move(user); }
    /// Whether a job of this owner may be ended or removed from here: by its owner, by an admin,
    /// and by anyone without TLS. Errors: Refused naming the owner.
    [[nodiscard]] Status check_owner(const std::string& of_job) const;

    /// Whether the holder's certificate is still good, and the holder is not refused. Nobody is
    /// anybody without TLS, or joining. Errors: Refused saying why not.
    [[nodiscard]] Status check_holder() const;
    /// Whether the holder may greet in this role. Errors: Refused saying why not.
    [[nodiscard]] Status check(Role role) const;
    /// Whether the holder may send this, as a client. Errors: Refused saying why not.
    [[nodiscard]] Status check(const Message& message) const;

  private:
    MasterIdentity* identity_ = nullptr;
    std::optional<Identity> holder_;
    std::string user_;
};

} // namespace cd
