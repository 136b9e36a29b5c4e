#include "master/base/file_locks.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace cd {

namespace {

/// Returns 0, or the error number of the first lock that failed.
int lock_both_ways(int file) {
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        return errno;
    }
    // NFS makes both kinds of locks of one kind, which would conflict.
    ::flock(file, LOCK_UN);
    struct flock range {};
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_len = 1;
    return ::fcntl(file, F_SETLK, &range) == 0 ? 0 : errno;
}

} // namespace

Status check_file_locks(const std::filesystem::path& directory) {
    std::string name = (directory / "locks.XXXXXX").string();
    const int file = ::mkostemp(name.data(), O_CLOEXEC);
    if (file < 0) {
        return Done{}; // A full disk, for example. What opens the state finds out whether it can.
    }
    ::unlink(name.c_str());
    const int failure = lock_both_ways(file);
    ::close(file);
    if (failure == 0) {
        return Done{};
    }
    return Error{
        ErrorCode::Io,
        directory.string() + ": this file system has no file locks (" +
            std::error_code(failure, std::generic_category()).message() +
            "), which the state of a master needs; choose a --state on a local disk, or "
            "have the file system mounted with locks (NFS with a lock service, Lustre with "
            "flock)"};
}

} // namespace cd
