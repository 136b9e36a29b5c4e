#include "client/formats/output_file.hpp"

#include "common/core/errors.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace cd {

namespace {

/// Returns the error of a failed write: Incomplete for standard output, Io for a file.
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

Status OutputFile::write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
        return io_error(path_);
    }
    return Done{};
}

Status OutputFile::commit() {
    if (std::fflush(file_.get()) != 0) {
        return io_error(path_);
    }
    if (path_.empty()) {
        return Done{};
    }
    if (fsync(fileno(file_.get())) != 0) {
        return io_error(path_);
    }
    file_.reset();
    if (std::rename(partial_.c_str(), path_.c_str()) != 0) {
        return io_error(path_);
    }
    return Done{};
}

Status write_file(const std::filesystem::path& path, std::string_view bytes) {
    auto file = CD_TRY(OutputFile::create(path));
    CD_TRY(file.write(bytes));
    return file.commit();
}

Result<std::string> read_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return Error{ErrorCode::NotFound, path.string() + ": no such file"};
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) {
        return Error{ErrorCode::Io, path.string() + ": cannot be read, or is empty"};
    }
    return std::move(text).str();
}

} // namespace cd
