#include "client/import/foreign/assimp_import.hpp"

#include "client/import/foreign/assimp_scene.hpp"
#include "client/import/foreign/child_call.hpp"
#include "client/import/imported_bytes.hpp"
#include "common/core/limits/client.hpp"
#include "common/core/timing/client.hpp"

#include <system_error>

namespace cd {

namespace {

ChildLimits limits_for(std::uint64_t file_bytes) {
    ChildLimits limits;
    limits.memory_bytes =
        limits::reader_memory_bytes_min + limits::reader_memory_per_file_byte * file_bytes;
    limits.processor_time = timing::reader_seconds_min +
                            std::chrono::seconds(file_bytes / limits::reader_file_bytes_per_second);
    limits.real_time = limits::reader_real_seconds_each * limits.processor_time;
    return limits;
}

std::string explain(ChildEnd end, const ChildLimits& limits) {
    switch (end) {
    case ChildEnd::OutOfMemory:
        return "the reader wants more than " + std::to_string(limits.memory_bytes >> 20) +
               " MiB of memory";
    case ChildEnd::OutOfTime:
        return "the reader did not end within " + std::to_string(limits.processor_time.count()) +
               " s";
    default:
        return "the reader crashed";
    }
}

} // namespace

Result<ImportedMesh> import_with_assimp(const std::filesystem::path& path,
                                        const ImportOptions& options) {
    std::error_code error;
    const std::uint64_t file_bytes = std::filesystem::file_size(path, error);
    const ChildLimits limits = limits_for(error ? 0 : file_bytes);
    const auto read = [&] { return to_bytes(read_with_assimp(path, options)); };
    const auto answer = call_in_child(read, limits, options.is_stopped);
    if (!answer) {
        return Error{answer.error().code, path.string() + ": " + answer.error().detail};
    }
    if (answer.value().end == ChildEnd::Stopped) {
        return Error{ErrorCode::Interrupted, path.string() + ": stopped while it was read"};
    }
    if (answer.value().end == ChildEnd::Answered) {
        if (auto imported = imported_from_bytes(answer.value().bytes)) {
            return std::move(*imported);
        }
    }
    return Error{ErrorCode::BadInput,
                 path.string() + ": " + explain(answer.value().end, limits) + " (assimp " +
                     assimp_version() + "); convert the file to glTF, OBJ, PLY or STL"};
}

} // namespace cd
