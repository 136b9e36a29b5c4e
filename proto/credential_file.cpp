#include "proto/credential_file.hpp"

#include "common/core/disk_file.hpp"
#include "common/core/limits.hpp"

#include <sys/stat.h>

#include <array>
#include <span>

namespace cd {

namespace {

constexpr std::string_view block_begin = "-----BEGIN ";
constexpr std::uint64_t file_bytes_max = 4 * limits::certificate_bytes_max;

/// The parts of a PEM file, each from its first line on.
std::array<std::string, 3> three_blocks(std::string_view text) {
    std::array<std::string, 3> blocks;
    std::size_t begin = text.find(block_begin);
    for (std::string& block : blocks) {
        if (begin == std::string_view::npos) {
            break;
        }
        const std::size_t next = text.find(block_begin, begin + 1);
        block = text.substr(begin, next - begin);
        begin = next;
    }
    return blocks;
}

Status check_owner_alone(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        return Error{ErrorCode::Io, "cannot look at " + path.string()};
    }
    if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return Error{ErrorCode::Refused,
                     path.string() + " may be read by others than its owner: chmod 600 it, or "
                                     "better, join anew"};
    }
    return Done{};
}

} // namespace

std::filesystem::path credential_path(const std::filesystem::path& folder, const Endpoint& master) {
    return folder / (master.host + "_" + std::to_string(master.port) + ".pem");
}

Status write_private(const std::filesystem::path& path, std::string_view text) {
    if (Status made = make_directories(path.parent_path()); !made) {
        return made;
    }
    Result<DiskFile> file = DiskFile::create_for(path);
    if (!file) {
        return file.error();
    }
    if (Status written = file.value().write_at(0, std::as_bytes(std::span(text))); !written) {
        return written;
    }
    return file.value().commit();
}

Result<std::string> read_private(const std::filesystem::path& path) {
    const Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return file.error();
    }
    if (const Status own = check_owner_alone(path); !own) {
        return own.error();
    }
    const Result<std::uint64_t> size = file.value().size();
    if (!size || size.value() > file_bytes_max) {
        return size ? Error{ErrorCode::TooLarge, path.string() + " is too large"} : size.error();
    }
    const Result<Bytes> bytes = file.value().read_at(0, size.value());
    if (!bytes) {
        return bytes.error();
    }
    return std::string(reinterpret_cast<const char*>(bytes.value().data()), bytes.value().size());
}

Status write_credential(const std::filesystem::path& path, const Credential& credential) {
    return write_private(path, credential.key + credential.certificate + credential.authority);
}

Result<Credential> read_credential(const std::filesystem::path& path) {
    const Result<std::string> text = read_private(path);
    if (!text) {
        return text.error();
    }
    auto [key, certificate, authority] = three_blocks(text.value());
    Credential credential{std::move(key), std::move(certificate), std::move(authority)};
    if (const Result<Identity> identity = read_identity(credential.certificate); !identity) {
        return Error{ErrorCode::BadInput,
                     path.string() + " is no credential: " + identity.error().detail};
    }
    return credential;
}

WallTime renew_at(const Identity& identity) {
    const auto life = identity.until - identity.from - limits::clock_difference_max;
    return identity.until - life / 2;
}

} // namespace cd
