// Reads typed members of a glTF file's JSON objects.
#pragma once

#include "common/core/errors.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// One JSON object and its name in messages (empty for the whole file). Getters return nothing for
/// a missing member. For a member of the wrong type they call `refuse`, which throws a `Refusal`.
class GltfFields {
  public:
    using Json = nlohmann::json;

    /// Refuses JSON that is not an object; `place` is the object's name in messages.
    GltfFields(const Json& json, std::string place);

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] bool has(const char* key) const;
    [[nodiscard]] std::optional<std::uint64_t> whole(const char* key) const;
    /// Returns a whole number; refuses an object without it.
    [[nodiscard]] std::uint64_t needed_whole(const char* key) const;
    /// Returns an index; refuses one that is not below `count`.
    [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t count) const;
    /// Returns an index below `count`; refuses an object without it.
    [[nodiscard]] std::size_t needed_index(const char* key, std::size_t count) const;
    [[nodiscard]] bool flag(const char* key) const;
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key) const;
    /// Returns an array of exactly `count` numbers; refuses one of another length.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key,
                                                             std::size_t count) const;
    /// Returns an array of indices below `count`; empty if the member is missing.
    [[nodiscard]] std::vector<std::size_t> indices(const char* key, std::size_t count) const;
    /// Returns an array; empty if the member is missing.
    [[nodiscard]] const Json& list(const char* key) const;
    [[nodiscard]] std::optional<GltfFields> object(const char* key) const;

    /// Refuses the file with an error that names this object.
    [[noreturn]] void refuse(const std::string& what) const {
        throw Refusal{bad_input(place_.empty() ? what : place_ + ": " + what)};
    }

  private:
    [[nodiscard]] const Json* find(const char* key) const;
    [[nodiscard]] std::size_t
    checked_index(const Json& value, const char* key, std::size_t count) const;

    const Json* json_;
    std::string place_;
};

} // namespace cd
