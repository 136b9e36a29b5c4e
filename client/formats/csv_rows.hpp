// Classes that the writers of CSV files share.
#pragma once

#include "client/formats/output_file.hpp"
#include "client/formats/part_finder.hpp"
#include "common/core/result.hpp"
#include "common/geometry/mesh.hpp"

#include <charconv>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cd {

/// A text to which pieces are appended without making a string of each piece.
class TextBuffer {
  public:
    /// Appends pieces: text, integers in decimal, doubles as the shortest decimal that reads back
    /// as that double.
    template <class... Pieces>
    void add(const Pieces&... pieces) {
        (add_piece(pieces), ...);
    }

    [[nodiscard]] std::string_view text() const { return text_; }
    /// Clears the text and keeps its memory.
    void clear() { text_.clear(); }

  private:
    void add_piece(std::string_view text) { text_.append(text); }
    template <class Number>
    requires std::integral<Number> || std::floating_point<Number>
    void add_piece(Number number) {
        static_assert(!std::same_as<Number, char> && !std::same_as<Number, bool>);
        char digits[32]; // NOLINT(modernize-avoid-c-arrays): not initialised.
        text_.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    }

    std::string text_;
};

/// Names the part of a triangle as a CSV field; empty for a triangle without a part.
class PartFields {
  public:
    explicit PartFields(const std::shared_ptr<const Mesh>& mesh);

    [[nodiscard]] std::string_view of(std::uint32_t triangle);

  private:
    PartFinder parts_;
    std::vector<std::string> fields_;
};

/// A file of rows, written in large pieces.
class RowFile {
  public:
    explicit RowFile(OutputFile file) : file_(std::move(file)) {}
    /// Creates a file with a header row. Errors: Io naming the file.
    [[nodiscard]] static Result<RowFile> create(const std::filesystem::path& path,
                                                std::string_view header);

    template <class... Pieces>
    [[nodiscard]] Status add(const Pieces&... pieces) {
        rows_.add(pieces...);
        return rows_.text().size() < bytes_at_once ? Status(Done{}) : write();
    }
    [[nodiscard]] Status commit();

  private:
    static constexpr std::size_t bytes_at_once = 1u << 18;

    [[nodiscard]] Status write();

    OutputFile file_;
    TextBuffer rows_;
};

} // namespace cd
