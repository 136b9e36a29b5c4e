// Reads the numbers in the data of a PLY file, in text or binary form.
#pragma once

#include "client/import/text/ply_header.hpp"
#include "client/import/text/text_reader.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cd {

/// Reads the data of a text PLY: one element a line; blank lines are skipped.
class PlyText {
  public:
    PlyText(const MeshSource& source, const PlyHeader& header);

    /// Moves to the next element. False at the end of the file.
    [[nodiscard]] bool begin_element();
    /// False if the element has more numbers than its properties.
    [[nodiscard]] bool end_element();

    /// Reads the element's next number; returns nothing if it is missing or invalid.
    [[nodiscard]] std::optional<double> number(PlyType type);
    [[nodiscard]] std::optional<std::int64_t> integer(PlyType type);
    [[nodiscard]] bool skip(PlyType type);

    /// Returns the error for a missing or invalid number, with the line and the text found in place
    /// of the number.
    [[nodiscard]] Error no_number(const std::string& element) const;
    /// Returns the error BadInput naming the file and the line.
    [[nodiscard]] Error refusal(const std::string& detail) const;

    /// True if the remaining bytes suffice for the elements: a number takes at least two, with the
    /// blank after it.
    [[nodiscard]] bool has_room_for(const PlyElement& element) const;
    [[nodiscard]] bool is_at_end();

  private:
    const MeshSource& source_;
    TextReader text_;
    std::string_view word_;
};

/// Reads the data of a binary PLY.
class PlyBinary {
  public:
    PlyBinary(const MeshSource& source, const PlyHeader& header);

    [[nodiscard]] bool begin_element();
    [[nodiscard]] bool end_element() const { return true; }

    [[nodiscard]] std::optional<double> number(PlyType type);
    [[nodiscard]] std::optional<std::int64_t> integer(PlyType type);
    [[nodiscard]] bool skip(PlyType type);

    [[nodiscard]] Error no_number(const std::string& element) const;
    [[nodiscard]] Error refusal(const std::string& detail) const;

    [[nodiscard]] bool has_room_for(const PlyElement& element) const;
    /// True if only zeros and blanks are left, which are ignored.
    [[nodiscard]] bool is_at_end() const;

  private:
    [[nodiscard]] std::optional<std::uint64_t> take(PlyType type);

    const MeshSource& source_;
    bool is_big_endian_;
    std::size_t at_;
    std::size_t element_begin_;
};

} // namespace cd
