#include "proto/access/credential_file.hpp"

#include "common/core/files/disk_file.hpp"
#include "common/core/files/state_folder.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/wire.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <span>
#include <system_error>

namespace cd {

namespace {

constexpr std::string_view block_begin = "-----BEGIN ";
constexpr std::uint64_t file_bytes_max = 4 * limits::certificate_bytes_max;

/// Returns the first three blocks of a PEM file, each from its BEGIN line on.
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

/// A file open for reading.
class Opened {
  public:
    explicit Opened(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }
    [[nodiscard]] int get() const { return descriptor_; }

  private:
    int descriptor_;
};

/// Checks owner and mode of the open file, since its path may name another file by now.
Status check_owner_alone(const Opened& file, const std::filesystem::path& path, FileOwner owner) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return Error{ErrorCode::Io, path.string() + " is no file"};
    }
    if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
        return Error{ErrorCode::Refused,
                     path.string() + " may be read by others than its owner: chmod 600 it, or "
                                     "better, join anew"};
    }
    // The owner can read the key, so only this user may own the file, or root, who can read any.
    if (owner == FileOwner::UserOrRoot && status.st_uid != ::geteuid() && status.st_uid != 0) {
        return Error{ErrorCode::Refused, path.string() + " belongs to another user"};
    }
    return Done{};
}

/// Reads up to one byte more than the size limit, so that the caller sees a file that is too large.
Result<std::string> read_all(const Opened& file, const std::filesystem::path& path) {
    std::string text(file_bytes_max + 1, '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t count = ::read(file.get(), text.data() + size, text.size() - size);
        if (count == 0) {
            break;
        }
        if (count < 0 && errno != EINTR) {
            return Error{ErrorCode::Io, "cannot read " + path.string()};
        }
        size += count < 0 ? 0 : static_cast<std::size_t>(count);
    }
    text.resize(size);
    return text;
}

/// Creates a temporary file in the folder of `path`, and the folder if it is missing.
Result<DiskFile> create_private(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(path, error);
    if (error || !whole.has_filename()) {
        return Error{ErrorCode::BadInput, "'" + path.string() + "' is no name of a file"};
    }
    if (std::filesystem::is_directory(whole, error)) {
        return Error{ErrorCode::BadInput, path.string() + " is a folder"};
    }
    if (const Status made = make_private_folder(whole.parent_path()); !made) {
        return made.error();
    }
    return DiskFile::create_for(whole);
}

} // namespace

std::filesystem::path credential_path(const std::filesystem::path& folder, const Endpoint& master) {
    return folder / (master.host + "_" + std::to_string(master.port) + ".pem");
}

Status check_can_write(const std::filesystem::path& path) {
    const Result<DiskFile> file = create_private(path);
    return file ? Status(Done{}) : Status(file.error());
}

Status write_private(const std::filesystem::path& path, std::string_view text) {
    Result<DiskFile> file = create_private(path);
    if (!file) {
        return file.error();
    }
    if (Status written = file.value().write_at(0, std::as_bytes(std::span(text))); !written) {
        return written;
    }
    return file.value().commit();
}

Result<std::string> read_private(const std::filesystem::path& path, FileOwner owner) {
    const Opened file(path);
    if (file.get() < 0) {
        const std::error_code why(errno, std::generic_category());
        return Error{errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Io,
                     "cannot open " + path.string() + ": " + why.message()};
    }
    if (const Status own = check_owner_alone(file, path, owner); !own) {
        return own.error();
    }
    Result<std::string> text = read_all(file, path);
    if (text && text.value().size() > file_bytes_max) {
        return Error{ErrorCode::TooLarge, path.string() + " is too large"};
    }
    return text;
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
    const auto life = identity.until - identity.from - timing::clock_difference_max;
    return identity.until - life / 2;
}

} // namespace cd
