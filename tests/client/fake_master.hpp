// A scripted master on loopback.
#pragma once

#include "proto/channel/channel.hpp"

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace cd::tests {

/// Listens on a port chosen by the system, on its own thread.
class FakeMaster {
  public:
    /// Returns the answers to one message, in order; nothing closes the connection.
    using Answer = std::function<std::optional<std::vector<Message>>(const Message&)>;

    /// Calls `answer` on the master's thread, also with each connection's Hello.
    explicit FakeMaster(Answer answer)
        : answer_(std::move(answer)),
          acceptor_(context_, asio::ip::tcp::endpoint(asio::ip::address_v4::loopback(), 0)) {
        spawn(context_.get_executor(), "fake master", serve());
        thread_ = std::thread([this] { context_.run(); });
    }
    FakeMaster(const FakeMaster&) = delete;
    FakeMaster& operator=(const FakeMaster&) = delete;
    ~FakeMaster() {
        asio::post(context_, [this] {
            acceptor_.close();
            for (const auto& channel : channels_) {
                channel->close();
            }
        });
        thread_.join();
    }

    [[nodiscard]] std::string address() const {
        return "127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port());
    }
    /// Returns all messages received so far, in order of arrival.
    [[nodiscard]] std::vector<Message> received() {
        const std::lock_guard lock(mutex_);
        return received_;
    }
    /// Returns the messages of one kind.
    template <class T>
    [[nodiscard]] std::vector<T> received_of() {
        std::vector<T> found;
        for (const Message& message : received()) {
            if (const auto* value = std::get_if<T>(&message)) {
                found.push_back(*value);
            }
        }
        return found;
    }

    /// Returns the answer to a Hello of a master without access control.
    [[nodiscard]] static std::vector<Message> welcome() { return {Welcome{}}; }

  private:
    asio::awaitable<void> serve() {
        while (true) {
            boost::system::error_code error;
            asio::ip::tcp::socket socket(context_);
            co_await acceptor_.async_accept(socket,
                                            asio::redirect_error(asio::use_awaitable, error));
            if (error) {
                co_return;
            }
            channels_.push_back(Channel::make(std::make_unique<Stream>(std::move(socket))));
            spawn(context_.get_executor(), "fake conversation", converse(channels_.back()));
        }
    }

    asio::awaitable<void> converse(std::shared_ptr<Channel> channel) {
        while (true) {
            const Result<Message> message = co_await channel->receive(std::chrono::seconds(60));
            if (!message) {
                co_return;
            }
            {
                const std::lock_guard lock(mutex_);
                received_.push_back(message.value());
            }
            const auto answers = answer_(message.value());
            if (!answers) {
                channel->close(true);
                co_return;
            }
            for (const Message& answer : *answers) {
                channel->send(answer);
            }
        }
    }

    Answer answer_;
    asio::io_context context_{1};
    asio::ip::tcp::acceptor acceptor_;
    std::vector<std::shared_ptr<Channel>> channels_;
    std::mutex mutex_;
    std::vector<Message> received_;
    std::thread thread_;
};

} // namespace cd::tests
