// Reads typed values from the tables of a TOML document and keeps the first problem.
#pragma once

#include "client/base/words.hpp"
#include "common/core/result.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// Keeps the first problem of a document: later ones often only follow from it.
class TomlProblem {
  public:
    explicit TomlProblem(std::string file) : file_(std::move(file)) {}

    /// `where` is the place of the faulty node.
    void report(const toml::source_region& where, const std::string& what) {
        if (!error_) {
            error_ = Error{ErrorCode::BadInput,
                           file_ + ":" + std::to_string(where.begin.line) + ": " + what};
        }
    }

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    std::string file_;
    std::optional<Error> error_;
};

/// Reads the values of one table. A missing key gives nothing or null without a report; a value of
/// another type than asked for is reported, and gives nothing or null.
class TomlFields {
  public:
    /// `name` is the table's name in messages. Reports the first key that is not among `known`.
    TomlFields(const toml::table& table,
               std::string name,
               TomlProblem& problem,
               std::initializer_list<std::string_view> known);

    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
    [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
    /// A text that must be one of `words`.
    [[nodiscard]] std::optional<std::string> word(std::string_view key,
                                                  std::span<const std::string_view> words) const;
    /// True if the key's value is this text.
    [[nodiscard]] bool says(std::string_view key, std::string_view text) const;
    [[nodiscard]] std::optional<double> number(std::string_view key) const; ///< A finite number.
    [[nodiscard]] std::optional<std::uint64_t>
    integer(std::string_view key, std::uint64_t min, std::uint64_t max) const;
    [[nodiscard]] std::optional<bool> boolean(std::string_view key) const;
    [[nodiscard]] const toml::table* table(std::string_view key) const;
    [[nodiscard]] const toml::array* array(std::string_view key) const;
    /// An array of exactly `count` finite numbers; `shape` describes them in the report.
    [[nodiscard]] std::optional<std::vector<double>>
    numbers(std::string_view key, std::size_t count, std::string_view shape) const;

    /// The position of the key's value, or of the table if the key is missing.
    [[nodiscard]] const toml::source_region& place(std::string_view key) const;
    void report(std::string_view key, const std::string& what) const;

  private:
    void wrong_type(std::string_view key, std::string_view wanted) const;

    const toml::table& table_;
    std::string name_;
    TomlProblem& problem_;
};

} // namespace cd
