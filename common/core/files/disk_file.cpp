#include "common/core/files/disk_file.hpp"

#include "common/core/check.hpp"
#include "common/core/host/log.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace cd {

namespace {

Error system_failure(const std::string& what, const std::filesystem::path& path) {
    const std::error_code reason(errno, std::generic_category());
    const ErrorCode code = errno == ENOENT ? ErrorCode::NotFound : ErrorCode::Io;
    return {code, "cannot " + what + " " + path.string() + ": " + reason.message()};
}

Error io_failure(const std::string& what, const std::filesystem::path& path) {
    return {ErrorCode::Io, system_failure(what, path).detail};
}

/// Creates a file named `stem`, `temporary_marker` and a random suffix; sets `stem` to that name.
int make_unique(std::string& stem) {
    stem += std::string(temporary_marker) + "XXXXXX";
    return ::mkostemp(stem.data(), O_CLOEXEC);
}

} // namespace

FileMapping::~FileMapping() {
    if (!bytes_.empty()) {
        // munmap takes a non-const pointer but does not change the memory.
        ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
    }
}

DiskFile::DiskFile(int descriptor, std::filesystem::path path, std::filesystem::path temporary)
    : descriptor_(descriptor), path_(std::move(path)), temporary_(std::move(temporary)) {}

DiskFile::DiskFile(DiskFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})) {}

DiskFile& DiskFile::operator=(DiskFile&& other) noexcept {
    if (this != &other) {
        close();
        descriptor_ = std::exchange(other.descriptor_, -1);
        path_ = std::move(other.path_);
        temporary_ = std::exchange(other.temporary_, {});
    }
    return *this;
}

DiskFile::~DiskFile() {
    close();
}

void DiskFile::close() {
    if (!temporary_.empty()) {
        ::unlink(temporary_.c_str());
    }
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

Result<DiskFile> DiskFile::open(const std::filesystem::path& path) {
    // Without O_NONBLOCK, opening a FIFO would block until another process opens it to write.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) {
        return system_failure("open", path);
    }
    DiskFile file(descriptor, path, {});
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        return Error{ErrorCode::Io, path.string() + " is no regular file"};
    }
    return file;
}

Result<DiskFile> DiskFile::create_for(const std::filesystem::path& path) {
    std::string name = path.string();
    const int descriptor = make_unique(name);
    if (descriptor < 0) {
        return io_failure("create", name);
    }
    return DiskFile(descriptor, path, name);
}

Result<DiskFile> DiskFile::open_to_write(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return io_failure("open", path);
    }
    return DiskFile(descriptor, path, {});
}

Result<DiskFile> DiskFile::lock(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return io_failure("create", path);
    }
    DiskFile file(descriptor, path, {});
    const Status locked = file.lock_it();
    return locked ? Result<DiskFile>(std::move(file)) : locked.error();
}

Result<DiskFile> DiskFile::lock_existing(const std::filesystem::path& path) {
    Result<DiskFile> file = open(path);
    if (!file) {
        return file;
    }
    const Status locked = file.value().lock_it();
    return locked ? std::move(file) : locked.error();
}

Status DiskFile::lock_it() const {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        return Error{ErrorCode::Io,
                     path_.parent_path().string() + " is in use by another process; give this one "
                                                    "a directory of its own"};
    }
    return Done{};
}

Status DiskFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count =
            ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return io_failure("write", path_);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
    return Done{};
}

Result<Bytes> DiskFile::read_at(std::uint64_t offset, std::uint64_t size) const {
    const Result<std::uint64_t> there = this->size();
    if (!there) {
        return there.error();
    }
    if (offset > there.value() || size > there.value() - offset) {
        return damaged_file(path_, "it is cut short");
    }
    Bytes bytes(size);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::pread(descriptor_,
                                      bytes.data() + done,
                                      bytes.size() - done,
                                      static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return io_failure("read", path_);
        }
        if (count == 0) {
            return damaged_file(path_, "it is cut short");
        }
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

Result<std::uint64_t> DiskFile::size() const {
    struct stat facts {};
    if (::fstat(descriptor_, &facts) != 0) {
        return io_failure("examine", path_);
    }
    return static_cast<std::uint64_t>(facts.st_size);
}

bool DiskFile::has_its_name() const {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor_, &opened) == 0 && ::stat(path_.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

Status DiskFile::resize(std::uint64_t size) const {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) {
        return io_failure("resize", path_);
    }
    return Done{};
}

Status DiskFile::sync() const {
    if (::fdatasync(descriptor_) != 0) {
        return io_failure("sync", path_);
    }
    return Done{};
}

Result<FileMapping> DiskFile::map() const {
    const Result<std::uint64_t> size = this->size();
    if (!size) {
        return size.error();
    }
    if (size.value() == 0) {
        return FileMapping({});
    }
    void* const begin =
        ::mmap(nullptr, size.value(), PROT_READ, MAP_PRIVATE | MAP_POPULATE, descriptor_, 0);
    if (begin == MAP_FAILED) {
        return io_failure("map", path_);
    }
    return FileMapping({static_cast<const std::byte*>(begin), size.value()});
}

Status DiskFile::commit(Durability durability) {
    CD_CHECK(!temporary_.empty());
    const bool synced = durability == Durability::Synced;
    if (synced && ::fsync(descriptor_) != 0) {
        return io_failure("sync", path_);
    }
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
        return io_failure("name", path_);
    }
    temporary_.clear();
    return synced ? sync_directory(path_.parent_path()) : Status(Done{});
}

Status DiskFile::commit_as(const std::filesystem::path& path, Durability durability) {
    path_ = path;
    return commit(durability);
}

Status make_directories(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        return Error{ErrorCode::Io, "cannot create " + directory.string() + ": " + error.message()};
    }
    return Done{};
}

Result<std::filesystem::path> make_temporary_folder(const std::string& name) {
    const char* const given = std::getenv("TMPDIR");
    const std::filesystem::path parent = given != nullptr && *given != '\0' ? given : "/tmp";
    std::string folder = (parent / (name + "-XXXXXX")).string();
    if (::mkdtemp(folder.data()) == nullptr) {
        return Error{ErrorCode::Io,
                     "cannot create a folder in " + parent.string() + ": " + std::strerror(errno) +
                         "; set TMPDIR to another folder"};
    }
    return std::filesystem::path(folder);
}

Status sync_directory(const std::filesystem::path& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return io_failure("open", directory);
    }
    const bool failed = ::fsync(descriptor) != 0;
    const Error error = io_failure("sync", directory);
    ::close(descriptor);
    return failed ? Status(error) : Status(Done{});
}

Error damaged_file(const std::filesystem::path& path, const std::string& why) {
    return {ErrorCode::Io, path.string() + " is damaged: " + why};
}

Status set_aside(const std::filesystem::path& path, const std::string& why) {
    std::filesystem::path aside;
    int number = 0;
    do {
        aside = path.string() + ".damaged-" + std::to_string(++number);
    } while (std::filesystem::exists(aside));
    std::error_code error;
    std::filesystem::rename(path, aside, error);
    if (error) {
        return Error{ErrorCode::Io, "cannot set aside " + path.string() + ": " + error.message()};
    }
    log_warning("damaged file set aside: file={} to={} why={}", path.string(), aside.string(), why);
    return Done{};
}

} // namespace cd
