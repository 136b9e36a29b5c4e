// A file with data of a job's scenarios, for example their poses, in runs with checksums.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// Each run has the bytes of `limits::pose_run_scenarios` scenarios; the last may have fewer. An
/// index at the end holds each run's end and checksum, and the file's `Content`. The destructor
/// deletes an unsealed file. Takes 16 bytes of memory per run.
class SpoolFile {
  public:
    /// Kind of data and number of scenarios, which `open` compares with the file's content.
    struct Content {
        std::vector<std::uint64_t> kind; ///< A magic number, then the format's parameters.
        std::uint64_t scenarios = 0;
    };
    /// Position of a run in the file, and the run's checksum.
    struct Run {
        std::uint64_t offset = 0;
        std::uint64_t bytes = 0;
        std::uint64_t sum = 0;
    };
    /// Consecutive scenarios of one run.
    struct Slice {
        std::uint64_t run = 0;
        std::size_t first = 0; ///< First scenario, counted from the start of the run.
        std::size_t count = 0;
    };

    /// Makes a temporary file beside `path`. Errors: Io.
    [[nodiscard]] static Result<SpoolFile> create(const std::filesystem::path& path,
                                                  Content content);
    /// Opens a sealed file and reads its index. Errors: Io naming a file that is missing, damaged
    /// or of another content.
    [[nodiscard]] static Result<SpoolFile> open(const std::filesystem::path& path, Content content);
    /// Splits scenarios [first, first + count) into the runs that hold them.
    [[nodiscard]] static std::vector<Slice> slices(std::uint64_t first, std::uint64_t count);

    [[nodiscard]] std::uint64_t scenarios() const { return content_.scenarios; }
    [[nodiscard]] std::size_t runs() const { return ends_.size(); }
    [[nodiscard]] Run run(std::uint64_t number) const;

    /// Appends the next run. Errors: Io.
    [[nodiscard]] Status append(std::span<const std::byte> run);
    /// Writes the index after the last run and renames the file to `path`, which is in its folder.
    /// Errors: Io.
    [[nodiscard]] Status seal(const std::filesystem::path& path, Durability durability);

    /// Reads a run and checks its checksum. Any thread, also during `append`. Errors: Io naming
    /// the file.
    [[nodiscard]] Result<Bytes> read(const Run& run) const;
    /// Returns an error that names the file as damaged.
    [[nodiscard]] Error damaged(const std::string& why) const;

  private:
    SpoolFile(DiskFile file, Content content)
        : file_(std::move(file)), content_(std::move(content)) {}
    [[nodiscard]] std::uint64_t end() const { return ends_.empty() ? 0 : ends_.back(); }
    /// Returns the part of the index that `Content` determines: kind and counts.
    [[nodiscard]] Bytes footer() const;
    [[nodiscard]] Status read_index();

    DiskFile file_;
    Content content_;
    std::vector<std::uint64_t> ends_; ///< Offset of the end of each run.
    std::vector<std::uint64_t> sums_; ///< Checksum of each run.
};

} // namespace cd
