// Reads typed values from the tables of a TOML document.
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
#include <utility>
#include <vector>

namespace cd {

/// The error BadInput "FILE:LINE: WHAT".
[[nodiscard]] Error
error_at(const std::string& file, const toml::source_region& where, const std::string& what);

/// Reads the values of one table. A missing key gives nothing or null. A value of another type than
/// asked for is refused.
class TomlFields {
  public:
    /// `file` and `name` are the names of file and table in messages. Refuses the first key that is
    /// not among `known`.
    TomlFields(const toml::table& table,
               std::string file,
               std::string name,
               std::initializer_list<std::string_view> known);
    /// The fields of a table in this one. `table` is not null.
    TomlFields(const toml::table* table,
               const TomlFields& parent,
               std::string name,
               std::initializer_list<std::string_view> known)
        : TomlFields(*table, parent.file_, std::move(name), known) {}

    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
    [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
    /// A text that must be one of `words`.
    [[nodiscard]] std::optional<std::string> word(std::string_view key,
                                                  std::span<const std::string_view> words) const;
    /// True if the key's value is this text.
    [[nodiscard]] bool says(std::string_view key, std::string_view text) const;
    /// A finite number.
    [[nodiscard]] std::optional<double> number(std::string_view key) const;
    [[nodiscard]] std::optional<std::uint64_t>
    integer(std::string_view key, std::uint64_t min, std::uint64_t max) const;
    [[nodiscard]] std::optional<bool> boolean(std::string_view key) const;
    [[nodiscard]] const toml::table* table(std::string_view key) const;
    [[nodiscard]] const toml::array* array(std::string_view key) const;
    /// An array of exactly `count` finite numbers; `shape` describes them in the error.
    [[nodiscard]] std::optional<std::vector<double>>
    numbers(std::string_view key, std::size_t count, std::string_view shape) const;

    /// Refuses the document, with the position of the key's value, or of the table if the key is
    /// missing.
    [[noreturn]] void refuse(std::string_view key, const std::string& what) const;
    /// Refuses the document, with the position of a node in this table.
    [[noreturn]] void refuse(const toml::node& node, const std::string& what) const;

  private:
    [[noreturn]] void wrong_type(std::string_view key, std::string_view wanted) const;

    const toml::table& table_;
    std::string file_;
    std::string name_;
};

} // namespace cd
