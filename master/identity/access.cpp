#include "master/identity/access.hpp"

#include "master/identity/identity.hpp"
#include "proto/codec/codec.hpp"

#include <string>

namespace cd {

namespace {

/// Ranks of clients; each has all rights of the ranks before it.
enum class Rank { None, Metrics, Submitter, Admin };

Rank rank_of(CertifiedRole role) {
    switch (role) {
    case CertifiedRole::Metrics:
        return Rank::Metrics;
    case CertifiedRole::Submitter:
        return Rank::Submitter;
    case CertifiedRole::Admin:
        return Rank::Admin;
    case CertifiedRole::Master:
    case CertifiedRole::Worker:
        break;
    }
    return Rank::None;
}

// Rank that each message needs: Metrics for status queries and heartbeats; Admin for tokens,
// removal of meshes and draining; Submitter for all others.
Rank rank_needed(const StatusQuery& /*message*/) {
    return Rank::Metrics;
}
Rank rank_needed(const Heartbeat& /*message*/) {
    return Rank::Metrics;
}
Rank rank_needed(const TokenCreate& /*message*/) {
    return Rank::Admin;
}
Rank rank_needed(const RemoveMesh& /*message*/) {
    return Rank::Admin;
}
Rank rank_needed(const DrainWorkers& /*message*/) {
    return Rank::Admin;
}
template <class Other>
Rank rank_needed(const Other& /*message*/) {
    return Rank::Submitter;
}

} // namespace

Status Access::check_holder() const {
    if (identity_ == nullptr || !holder_) {
        return Done{};
    }
    if (holder_->until <= identity_->now()) {
        return Error{ErrorCode::Refused,
                     "the certificate of '" + holder_->name + "' has expired; renew it"};
    }
    return identity_->check_refused(holder_->name);
}

Status Access::check(Role role) const {
    if (identity_ == nullptr) {
        return role == Role::Joiner
                   ? Status(Error{ErrorCode::Refused,
                                  "this master speaks without TLS; `cdmaster init` "
                                  "makes it an identity"})
                   : Status(Done{});
    }
    if (const Status holder = check_holder(); !holder || role == Role::Joiner) {
        return holder;
    }
    if (!holder_) {
        return Error{ErrorCode::Refused, "no certificate was shown: join with a token first"};
    }
    const bool is_worker = holder_->role == CertifiedRole::Worker;
    const bool is_client = rank_of(holder_->role) != Rank::None;
    if ((role == Role::Worker && is_worker) || (role == Role::Client && is_client)) {
        return Done{};
    }
    return Error{ErrorCode::Refused,
                 "the certificate of a " + std::string(to_text(holder_->role)) +
                     " is not that of a " + (role == Role::Worker ? "worker" : "client")};
}

Status Access::check_owner(const std::string& of_job) const {
    if (is_admin() || owner() == of_job) {
        return Done{};
    }
    return Error{ErrorCode::Refused,
                 "the job belongs to '" + of_job + "'; its owner or an admin may do that"};
}

Status Access::check_priority(std::int32_t priority) const {
    if (priority <= 0 || is_admin()) {
        return Done{};
    }
    return Error{ErrorCode::Refused,
                 "priority " + std::to_string(priority) + " needs the role admin, and '" + owner() +
                     "' is a submitter: choose 0 or below, or use an admin's credential"};
}

bool Access::is_admin() const {
    return identity_ == nullptr || (holder_ && holder_->role == CertifiedRole::Admin);
}

Status Access::check(const Message& message) const {
    if (identity_ == nullptr) {
        return Done{};
    }
    const Rank needed =
        std::visit([](const auto& content) { return rank_needed(content); }, message);
    if (holder_ && rank_of(holder_->role) >= needed) {
        return check_holder();
    }
    return Error{ErrorCode::Refused,
                 "the certificate of a " +
                     (holder_ ? std::string(to_text(holder_->role)) : std::string("nobody")) +
                     " does not allow '" + std::string(message_name(message_type(message))) + "'"};
}

} // namespace cd
