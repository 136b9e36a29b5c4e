// Reads typed values from the tables of a TOML document.
#pragma once

#include "common/core/result.hpp"
#include "common/core/words.hpp"

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cd {

/// Returns the error BadInput "FILE:LINE: WHAT".
[[nodiscard]] Error
error_at(const std::string& file, const toml::source_region& where, const std::string& what);

/// Lines of a document, by key; those of tables by "[NAME]".
using KeyLines = std::map<std::string, std::uint32_t, std::less<>>;

/// Returns the lines of a document's tables, and those of the keys in the tables `of`.
[[nodiscard]] KeyLines lines_of(const toml::table& document,
                                std::initializer_list<std::string_view> of);

/// Reads the values of one table. A missing key gives nothing or null. A value of the wrong type
/// ends the reading: `refuse` throws a `Refusal`.
class TomlFields {
  public:
    /// `file` and `name` are the names of the file and of the table in messages. Refuses the first
    /// key that is not among `known`.
    TomlFields(const toml::table& table,
               std::string file,
               std::string name,
               std::initializer_list<std::string_view> known);
    /// Reads the fields of `table`, which is not null and lies in the table of `parent`.
    TomlFields(const toml::table* table,
               const TomlFields& parent,
               std::string name,
               std::initializer_list<std::string_view> known)
        : TomlFields(*table, parent.file_, std::move(name), known) {}

    [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }
    [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
    /// Returns a text, which must be one of `words`.
    [[nodiscard]] std::optional<std::string> word(std::string_view key,
                                                  std::span<const std::string_view> words) const;
    /// True if the key's value is this text.
    [[nodiscard]] bool says(std::string_view key, std::string_view text) const;
    /// Returns a finite number.
    [[nodiscard]] std::optional<double> number(std::string_view key) const;
    [[nodiscard]] std::optional<std::uint64_t>
    integer(std::string_view key, std::uint64_t min, std::uint64_t max) const;
    [[nodiscard]] std::optional<bool> boolean(std::string_view key) const;
    [[nodiscard]] const toml::table* table(std::string_view key) const;
    [[nodiscard]] const toml::array* array(std::string_view key) const;
    [[nodiscard]] bool is_array(std::string_view key) const {
        return has(key) && table_.get(key)->is_array();
    }
    /// Returns the line "key = value" of a key that exists.
    [[nodiscard]] std::string line_of(std::string_view key) const;
    /// Returns exactly `count` finite numbers of an array; `shape` describes them in the error.
    [[nodiscard]] std::optional<std::vector<double>>
    numbers(std::string_view key, std::size_t count, std::string_view shape) const;

    /// Refuses the document with an error at the line of the key's value, or of the table if the
    /// key is missing.
    [[noreturn]] void refuse(std::string_view key, const std::string& what) const;
    /// Refuses the document with an error at the line of a node in this table.
    [[noreturn]] void refuse(const toml::node& node, const std::string& what) const;

  private:
    [[noreturn]] void wrong_type(std::string_view key, std::string_view wanted) const;

    const toml::table& table_;
    std::string file_;
    std::string name_;
};

} // namespace cd
