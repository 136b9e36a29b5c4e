#include "master/identity/identity.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"
#include "common/core/timing/wire.hpp"
#include "proto/access/credential_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace cd {

namespace {

constexpr const char* master_name = "master";
constexpr const char* admin_name = "admin";
constexpr std::array<std::string_view, 3> reserved_names{
    master_name, admin_name, "cdcluster authority"};

std::filesystem::path folder_of(const std::filesystem::path& state) {
    return state / "identity";
}

/// Where `init` makes an identity before it gets its name. A folder that is left there is of an
/// `init` that did not end.
std::filesystem::path unfinished_of(const std::filesystem::path& state) {
    return state / "identity.new";
}

std::filesystem::path key_path(const std::filesystem::path& folder) {
    return folder / "authority.key";
}
std::filesystem::path certificate_path(const std::filesystem::path& folder) {
    return folder / "authority.pem";
}
std::filesystem::path tokens_path(const std::filesystem::path& folder) {
    return folder / "tokens";
}

std::filesystem::path refused_path(const std::filesystem::path& folder) {
    return folder.parent_path() / "refused";
}

std::string_view trimmed(std::string_view line) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t begin = std::min(line.find_first_not_of(blank), line.size());
    return line.substr(begin, line.find_last_not_of(blank) + 1 - begin);
}

constexpr const char* remedy =
    "; nothing was changed: restore it from a copy, or move the folder away, run `cdmaster init`, "
    "and have everybody join again";

/// Returns the error for a missing CA certificate: NotFound if the folder is empty or missing,
/// BadInput if it has other files, Io if it cannot be read.
Error no_authority(const std::filesystem::path& folder) {
    std::error_code error;
    const std::filesystem::directory_iterator files(folder, error);
    if (!error && files != std::filesystem::directory_iterator()) {
        return {ErrorCode::BadInput,
                certificate_path(folder).string() + " is missing, but there is " +
                    files->path().string() + remedy};
    }
    return error && error != std::errc::no_such_file_or_directory
               ? Error{ErrorCode::Io, "cannot read " + folder.string() + ": " + error.message()}
               : Error{ErrorCode::NotFound, "there is no identity in " + folder.string()};
}

/// Reads the authority. Errors: NotFound if there is none; BadInput; Io.
Result<CertificateAuthority> read_authority(const std::filesystem::path& folder,
                                            FileOwner owner = FileOwner::UserOrRoot) {
    const Result<std::string> certificate = read_private(certificate_path(folder), owner);
    if (!certificate) {
        return certificate.error().code == ErrorCode::NotFound ? no_authority(folder)
                                                               : certificate.error();
    }
    const Result<std::string> key = read_private(key_path(folder), owner);
    if (!key) {
        return key.error().code == ErrorCode::NotFound ? Error{ErrorCode::Io, key.error().detail}
                                                       : key.error();
    }
    auto authority = CertificateAuthority::parse(certificate.value(), key.value());
    if (!authority) {
        return Error{ErrorCode::BadInput,
                     folder.string() + " holds " + authority.error().detail + remedy};
    }
    return authority;
}

/// Returns whether no peer may join under this name. Ignores case and trailing dots, as tools that
/// compare certificate names do.
bool is_reserved(std::string name) {
    name.erase(name.find_last_not_of('.') + 1);
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    return std::find(reserved_names.begin(), reserved_names.end(), name) != reserved_names.end();
}

Status write_authority(const std::filesystem::path& folder, const CertificateAuthority& authority) {
    CD_TRY(write_private(key_path(folder), authority.key()));
    return write_private(certificate_path(folder), authority.certificate());
}

/// Gives a folder whose files are on the disk its final name. Errors: Io.
Status rename_folder(const std::filesystem::path& from, const std::filesystem::path& to) {
    CD_TRY(sync_directory(from));
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (error) {
        return Error{ErrorCode::Io, "cannot create " + to.string() + ": " + error.message()};
    }
    return sync_directory(to.parent_path());
}

Result<TokenBook> read_tokens(const std::filesystem::path& folder,
                              FileOwner owner = FileOwner::UserOrRoot) {
    const Result<std::string> text = read_private(tokens_path(folder), owner);
    if (!text) {
        return text.error().code == ErrorCode::NotFound ? Result<TokenBook>(TokenBook())
                                                        : Result<TokenBook>(text.error());
    }
    auto tokens = TokenBook::parse(text.value());
    if (!tokens) {
        return Error{ErrorCode::BadInput,
                     tokens_path(folder).string() + ": " + tokens.error().detail +
                         "; nothing was changed: restore it from a copy, or move it away, and make "
                         "new tokens"};
    }
    return tokens;
}

} // namespace

Status MasterIdentity::init(const std::filesystem::path& state, const Options& options) {
    const std::filesystem::path folder = folder_of(state);
    Result<CertificateAuthority> authority = read_authority(folder);
    if (authority) {
        return MasterIdentity(folder, std::move(authority.value()), TokenBook(), options)
            .renew_admin();
    }
    if (authority.error().code != ErrorCode::NotFound) {
        return authority.error();
    }
    const std::filesystem::path unfinished = unfinished_of(state);
    std::error_code ignored; // Writing replaces the files that stay.
    std::filesystem::remove_all(unfinished, ignored);
    const MasterIdentity made(
        unfinished, CertificateAuthority::make(options.now()), TokenBook(), options);
    CD_TRY(write_authority(unfinished, made.authority_));
    CD_TRY(made.renew_admin());
    return rename_folder(unfinished, folder);
}

Result<std::unique_ptr<MasterIdentity>> MasterIdentity::open(const std::filesystem::path& state,
                                                             const Options& options) {
    const std::filesystem::path folder = folder_of(state);
    Result<CertificateAuthority> authority = read_authority(folder);
    if (!authority) {
        return authority.error().code == ErrorCode::NotFound
                   ? Result<std::unique_ptr<MasterIdentity>>(nullptr)
                   : Result<std::unique_ptr<MasterIdentity>>(authority.error());
    }
    Result<TokenBook> tokens = read_tokens(folder);
    if (!tokens) {
        return tokens.error();
    }
    std::unique_ptr<MasterIdentity> identity(new MasterIdentity(
        folder, std::move(authority.value()), std::move(tokens.value()), options));
    if (const Status valid = identity->keep_valid(); !valid) {
        return valid.error();
    }
    return identity;
}

Status MasterIdentity::check(const std::filesystem::path& state) {
    const std::filesystem::path folder = folder_of(state);
    const Result<CertificateAuthority> authority = read_authority(folder, FileOwner::Anyone);
    if (!authority) {
        return authority.error().code == ErrorCode::NotFound ? Status(Done{})
                                                             : Status(authority.error());
    }
    const Result<TokenBook> tokens = read_tokens(folder, FileOwner::Anyone);
    return tokens ? Status(Done{}) : Status(tokens.error());
}

std::filesystem::path MasterIdentity::admin_path(const std::filesystem::path& state) {
    return folder_of(state) / "admin.pem";
}

MasterIdentity::MasterIdentity(std::filesystem::path folder,
                               CertificateAuthority authority,
                               TokenBook tokens,
                               Options options)
    : folder_(std::move(folder)),
      authority_(std::move(authority)),
      tokens_(std::move(tokens)),
      options_(std::move(options)) {}

Status MasterIdentity::keep_valid() {
    if (tls_->now == nullptr || renew_at(*tls_->now->identity()) <= options_.now()) {
        renew_own();
    }
    const Result<Credential> admin = read_credential(folder_ / "admin.pem");
    const Result<Identity> identity =
        admin ? read_identity(admin.value().certificate) : Result<Identity>(admin.error());
    // A missing admin file is not recreated: somebody removed it on purpose.
    if (identity && renew_at(identity.value()) <= options_.now()) {
        return renew_admin();
    }
    return Done{};
}

void MasterIdentity::renew_own() {
    const Identity own =
        identity_from_now(CertifiedRole::Master, master_name, timing::master_certificate_life);
    auto tls = Tls::make(authority_.issue(own));
    CD_CHECK(tls.has_value());
    tls_->now = std::move(tls.value());
}

Status MasterIdentity::renew_admin() const {
    const Identity admin =
        identity_from_now(CertifiedRole::Admin, admin_name, timing::master_certificate_life);
    return write_credential(folder_ / "admin.pem", authority_.issue(admin));
}

Identity MasterIdentity::identity_from_now(CertifiedRole role,
                                           const std::string& name,
                                           std::chrono::seconds life) const {
    const WallTime now = options_.now();
    // Valid from a time in the past, because the peer's clock may be slow.
    return {role, name, now - timing::clock_difference_max, now + life};
}

Result<Certified> MasterIdentity::certify(const std::string& request,
                                          CertifiedRole role,
                                          const std::string& name) const {
    Result<std::string> certificate =
        authority_.sign(request, identity_from_now(role, name, options_.certificate_life));
    if (!certificate) {
        return certificate.error();
    }
    return Certified{std::move(certificate.value()), authority_.certificate()};
}

Status MasterIdentity::save_tokens() const {
    return write_private(tokens_path(folder_), tokens_.to_text());
}

Status MasterIdentity::check_refused(const std::string& name) const {
    const std::filesystem::path path = refused_path(folder_);
    std::error_code missing;
    if (!std::filesystem::exists(path, missing) && !missing) {
        return Done{};
    }
    std::ifstream file(path);
    std::size_t bytes = 0;
    for (std::string line; std::getline(file, line);) {
        bytes += line.size() + 1;
        if (bytes > limits::refused_bytes_max) {
            return Error{ErrorCode::Refused, path.string() + " is too long to be read"};
        }
        if (trimmed(line) == name) {
            return Error{ErrorCode::Refused, "'" + name + "' is refused by this cluster"};
        }
    }
    // An unreadable list refuses everybody, since it may name anybody.
    return file.eof() ? Status(Done{})
                      : Status(Error{ErrorCode::Refused, path.string() + " cannot be read"});
}

Result<Certified> MasterIdentity::join(const Join& message, const Sha256& binding) {
    if (is_reserved(message.name)) {
        return Error{ErrorCode::Refused,
                     "nobody joins under the name '" + message.name + "': choose another --name"};
    }
    if (const Status allowed = check_refused(message.name); !allowed) {
        return allowed.error();
    }
    const Result<CertifiedRole> role =
        tokens_.redeem({message.token, message.proof, binding, message.request}, options_.now());
    if (!role) {
        return role.error();
    }
    if (const Status saved = save_tokens(); !saved) {
        return saved.error();
    }
    return certify(message.request, role.value(), message.name);
}

Result<Certified> MasterIdentity::renew(const Renew& message, const Identity& holder) const {
    if (const Status allowed = check_refused(holder.name); !allowed) {
        return allowed.error();
    }
    return certify(message.request, holder.role, holder.name);
}

Result<TokenCreated> MasterIdentity::create_token(const TokenCreate& message) {
    const WallTime now = options_.now();
    const TokenBook::Terms terms{
        message.role,
        message.uses,
        now + std::chrono::seconds(std::min<std::uint64_t>(
                  message.seconds, 2 * std::chrono::seconds(timing::token_life_max).count()))};
    const Result<JoinToken> token = tokens_.create(terms, authority_.fingerprint(), now);
    if (!token) {
        return token.error();
    }
    if (const Status saved = save_tokens(); !saved) {
        return saved.error();
    }
    return TokenCreated{to_text(token.value())};
}

} // namespace cd
