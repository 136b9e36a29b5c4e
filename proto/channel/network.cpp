#include "proto/channel/network.hpp"

#include "proto/channel/listener.hpp"
#include "proto/channel/seats.hpp"

#include <utility>

namespace cd {

namespace {

Incoming incoming(asio::ip::tcp::socket accepted) {
    const auto socket = std::make_shared<asio::ip::tcp::socket>(std::move(accepted));
    boost::system::error_code gone;
    return {socket->remote_endpoint(gone).address(),
            peer_name(*socket),
            [socket](std::shared_ptr<const Tls> tls) {
                return accept_channel(std::move(*socket), std::move(tls));
            }};
}

class TcpListener final : public ChannelListener {
  public:
    explicit TcpListener(std::unique_ptr<Listener> listener) : listener_(std::move(listener)) {}

    [[nodiscard]] std::uint16_t port() const override { return listener_->port(); }
    void start(OnIncoming on_incoming) override {
        listener_->start([on_incoming = std::move(on_incoming)](asio::ip::tcp::socket socket) {
            on_incoming(incoming(std::move(socket)));
        });
    }
    void close() override { listener_->close(); }

  private:
    std::unique_ptr<Listener> listener_;
};

class TcpNetwork final : public Network {
  public:
    [[nodiscard]] asio::awaitable<Result<std::shared_ptr<Channel>>>
    connect(Target target, std::chrono::seconds timeout) override {
        return cd::connect(std::move(target), timeout);
    }
    [[nodiscard]] asio::awaitable<Status> reach(Endpoint endpoint,
                                                std::chrono::seconds timeout) override {
        return cd::reach(std::move(endpoint), timeout);
    }
    [[nodiscard]] Result<std::unique_ptr<ChannelListener>>
    listen(const asio::any_io_executor& executor, const Endpoint& endpoint) override {
        auto listener = Listener::open(executor, endpoint);
        if (!listener) {
            return listener.error();
        }
        return std::unique_ptr<ChannelListener>(
            std::make_unique<TcpListener>(std::move(listener.value())));
    }
};

} // namespace

Network& tcp_network() {
    static TcpNetwork network;
    return network;
}

} // namespace cd
