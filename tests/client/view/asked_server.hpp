// The server of a run that is viewed, asked in tests without a network.
#pragma once

#include "client/view/folder_source.hpp"
#include "client/view/held_answers.hpp"
#include "web/server/page_server.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace cd::tests {

/// Asks the server of a source, and waits for the whole answer.
class Server {
  public:
    explicit Server(std::unique_ptr<ViewedRun> run)
        : source_(context_.get_executor(), std::move(run), [] { return false; }),
          server_(context_.get_executor(), source_, {}) {}

    HeldAnswer ask(const std::string& path) {
        HeldAnswer answer{path, {}};
        bool is_whole = false;
        const auto work = asio::make_work_guard(context_);
        context_.restart(); // It stopped after the last answer.
        server_.answer(
            {"GET", "/api/v1/" + path, "localhost"},
            [](PageRight) { return Done{}; },
            [&](HttpAnswer got) {
                EXPECT_EQ(got.status, 200u) << path << ": " << got.body;
                answer.is_cut = std::ranges::any_of(
                    got.headers, [](const auto& header) { return header.first == "X-Cut"; });
                if (got.content == nullptr) {
                    const auto bytes = std::as_bytes(std::span(got.body));
                    answer.bytes.assign(bytes.begin(), bytes.end());
                    is_whole = true;
                    return;
                }
                got.content->read(
                    0, got.content->size(), [&, body = got.content](const auto& read) {
                        answer.bytes.assign(read.value().begin(), read.value().end());
                        is_whole = true;
                    });
            });
        while (!is_whole) {
            context_.run_one();
        }
        return answer;
    }

  private:
    asio::io_context context_;
    FolderSource source_;
    PageServer server_;
};

} // namespace cd::tests
