// The bytes of an HTTP answer, which are read piece by piece.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/result.hpp"
#include "proto/channel/asio.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace cd {

/// A body belongs to one answer.
class HttpBody {
  public:
    using Take = std::function<void(Result<std::span<const std::byte>>)>;

    HttpBody() = default;
    HttpBody(const HttpBody&) = delete;
    HttpBody& operator=(const HttpBody&) = delete;
    virtual ~HttpBody() = default;

    /// Number of bytes in all.
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Calls `take` once, on the thread of the answer's stream, with the `size` bytes from `offset`
    /// on, which exist. They are valid until the next call. Errors: Io.
    virtual void read(std::uint64_t offset, std::size_t size, Take take) = 0;
};

/// Makes a body of bytes in memory, which `owner` keeps alive.
[[nodiscard]] std::shared_ptr<HttpBody> make_memory_body(std::span<const std::byte> bytes,
                                                         std::shared_ptr<const void> owner);
[[nodiscard]] std::shared_ptr<HttpBody> make_memory_body(Bytes bytes);
[[nodiscard]] std::shared_ptr<HttpBody> make_memory_body(std::string text);

/// Makes a body of the first `size` bytes of a file. Pieces are read on `blocking`, which outlives
/// the body; `executor` is the stream's.
[[nodiscard]] std::shared_ptr<HttpBody>
make_file_body(DiskFile file, std::uint64_t size, Pool& blocking, asio::any_io_executor executor);

} // namespace cd
