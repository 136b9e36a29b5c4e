// Reads typed members of a glTF file's JSON objects and keeps the first problem.
#pragma once

#include "common/core/result.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cd {

/// Keeps the first problem of a document: later ones often only follow from it.
class GltfProblem {
  public:
    void report(const std::string& what) {
        if (!error_) {
            error_ = Error{ErrorCode::BadInput, what};
        }
    }

    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    std::optional<Error> error_;
};

/// One JSON object and its name in messages (empty for the whole file). Getters return nothing for
/// a missing member; they report a member of the wrong type and return nothing, too.
class GltfFields {
  public:
    using Json = nlohmann::json;

    /// Reports JSON that is not an object.
    GltfFields(const Json& json, std::string place, GltfProblem& problem);

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] bool has(const char* key) const;
    [[nodiscard]] std::optional<std::uint64_t> whole(const char* key) const;
    /// Like `whole`, but reports a missing member.
    [[nodiscard]] std::uint64_t needed_whole(const char* key) const;
    /// An index below `count`.
    [[nodiscard]] std::optional<std::size_t> index(const char* key, std::size_t count) const;
    /// Like `index`, but reports a missing member.
    [[nodiscard]] std::size_t needed_index(const char* key, std::size_t count) const;
    [[nodiscard]] bool flag(const char* key) const;
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key) const;
    /// Like `numbers`, but reports another count than `count`.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key,
                                                             std::size_t count) const;
    /// Indices below `count`; empty if the member is missing.
    [[nodiscard]] std::vector<std::size_t> indices(const char* key, std::size_t count) const;
    /// An array; empty if the member is missing.
    [[nodiscard]] const Json& list(const char* key) const;
    [[nodiscard]] std::optional<GltfFields> object(const char* key) const;

    void report(const std::string& what) const {
        problem_->report(place_.empty() ? what : place_ + ": " + what);
    }

  private:
    [[nodiscard]] const Json* find(const char* key) const;
    [[nodiscard]] std::size_t
    checked_index(const Json& value, const char* key, std::size_t count) const;

    const Json* json_;
    std::string place_;
    GltfProblem* problem_;
};

} // namespace cd
