// A job's results on disk, in the order in which they came, found by scenario.
#pragma once

#include "common/core/result.hpp"
#include "proto/message.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

namespace cd {

/// An append-only file of canonical records, each behind its length and checksum. The file goes
/// when this does. Memory: 16 bytes for each scenario answered. Any thread may call any member; all
/// block for the disk, `add` mostly for a copy into a buffer.
class ResultStore {
  public:
    /// A new file in `directory`, which is made if missing. Errors: Io.
    [[nodiscard]] static Result<std::unique_ptr<ResultStore>>
    create(const std::filesystem::path& directory, std::uint64_t scenarios);
    ResultStore(const ResultStore&) = delete;
    ResultStore& operator=(const ResultStore&) = delete;
    ~ResultStore();

    /// The record of a scenario that has none yet (`has`). Errors: TooLarge, Io.
    [[nodiscard]] Status add(std::uint64_t scenario, std::span<const std::byte> record);

    [[nodiscard]] bool has(std::uint64_t scenario) const;
    [[nodiscard]] std::uint64_t count() const; ///< Records that are here.

    /// The records of scenarios [first, first + count) up to the first that is not here or would
    /// bring the uncompressed records over `bytes_max`; one that is there is given whatever its
    /// size. `job` is left for the caller to set. Errors: Io, when a record is damaged or cannot be
    /// read.
    [[nodiscard]] Result<ResultsPart>
    read(std::uint64_t first, std::uint64_t count, std::uint64_t bytes_max) const;

  private:
    struct State;
    explicit ResultStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd
