#include "client/formats/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace cd {

namespace {

/// A failed write to standard output is Incomplete, since the output is not whole.
Error io_error(const std::filesystem::path& path) {
    return {path.empty() ? ErrorCode::Incomplete : ErrorCode::Io,
            (path.empty() ? "standard output" : path.string()) + ": " + std::strerror(errno)};
}

} // namespace

std::filesystem::path partial_path(const std::filesystem::path& path) {
    return path.parent_path() / (path.filename().string() + ".partial");
}

void OutputFile::Close::operator()(std::FILE* file) const {
    if (file != stdout) {
        std::fclose(file);
    }
}

Result<OutputFile> OutputFile::create(const std::filesystem::path& path) {
    const auto partial = partial_path(path);
    std::FILE* file = std::fopen(partial.c_str(), "wb");
    if (file == nullptr) {
        return io_error(partial);
    }
    return OutputFile(path, partial, file);
}

OutputFile OutputFile::standard_output() {
    return {{}, {}, stdout};
}

OutputFile::~OutputFile() {
    if (!file_ || partial_.empty()) {
        return;
    }
    file_.reset();
    std::error_code ignored;
    std::filesystem::remove(partial_, ignored);
}

Error OutputFile::failure() const {
    return io_error(path_);
}

Status OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
        return failure();
    }
    return Done{};
}

Status OutputFile::commit() {
    if (std::fflush(file_.get()) != 0) {
        return failure();
    }
    if (path_.empty()) {
        return Done{};
    }
    if (fsync(fileno(file_.get())) != 0) {
        return failure();
    }
    file_.reset();
    if (std::rename(partial_.c_str(), path_.c_str()) != 0) {
        return failure();
    }
    return Done{};
}

} // namespace cd
