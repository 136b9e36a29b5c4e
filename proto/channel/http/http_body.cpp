#include "proto/channel/http/http_body.hpp"

#include <utility>

namespace cd {

namespace {

class MemoryBody final : public HttpBody {
  public:
    MemoryBody(std::span<const std::byte> bytes, std::shared_ptr<const void> owner)
        : bytes_(bytes), owner_(std::move(owner)) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t offset, std::size_t size, Take take) override {
        take(bytes_.subspan(offset, size));
    }

  private:
    std::span<const std::byte> bytes_;
    std::shared_ptr<const void> owner_;
};

class FileBody final : public HttpBody, public std::enable_shared_from_this<FileBody> {
  public:
    FileBody(DiskFile file, std::uint64_t size, Pool& blocking, asio::any_io_executor executor)
        : file_(std::move(file)),
          size_(size),
          blocking_(blocking),
          executor_(std::move(executor)) {}

    [[nodiscard]] std::uint64_t size() const override { return size_; }
    void read(std::uint64_t offset, std::size_t size, Take take) override {
        blocking_.post([self = shared_from_this(), offset, size, take = std::move(take)]() mutable {
            Result<Bytes> piece = self->file_.read_at(offset, size);
            asio::post(self->executor_,
                       [self, piece = std::move(piece), take = std::move(take)]() mutable {
                           if (!piece) {
                               return take(piece.error());
                           }
                           self->piece_ = std::move(piece.value());
                           take(std::span<const std::byte>(self->piece_));
                       });
        });
    }

  private:
    DiskFile file_;
    std::uint64_t size_;
    Pool& blocking_;
    asio::any_io_executor executor_;
    Bytes piece_; ///< The bytes that were read last.
};

} // namespace

std::shared_ptr<HttpBody> make_memory_body(std::span<const std::byte> bytes,
                                           std::shared_ptr<const void> owner) {
    return std::make_shared<MemoryBody>(bytes, std::move(owner));
}

std::shared_ptr<HttpBody> make_memory_body(Bytes bytes) {
    const auto owner = std::make_shared<const Bytes>(std::move(bytes));
    return make_memory_body(*owner, owner);
}

std::shared_ptr<HttpBody> make_memory_body(std::string text) {
    const auto owner = std::make_shared<const std::string>(std::move(text));
    return make_memory_body(std::as_bytes(std::span(*owner)), owner);
}

std::shared_ptr<HttpBody>
make_file_body(DiskFile file, std::uint64_t size, Pool& blocking, asio::any_io_executor executor) {
    return std::make_shared<FileBody>(std::move(file), size, blocking, std::move(executor));
}

} // namespace cd
