#include "client/import/foreign/ac3d_text.hpp"

#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"

#include <array>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

namespace {

constexpr std::string_view magic = "AC3D";

/// The type of a surface: the low four bits of its flags.
enum class SurfaceType : unsigned { Polygon = 0, ClosedLine = 1, OpenLine = 2, Strip = 4 };

std::optional<unsigned> to_flags(std::string_view word) {
    const bool is_hex = word.starts_with("0x");
    word.remove_prefix(is_hex ? 2 : 0);
    return number_in<unsigned>(word, is_hex ? 16 : 10);
}

class Ac3dCounter {
  public:
    Ac3dCounter(const std::filesystem::path& path, std::string_view text)
        : path_(path), text_(text), rest_(text) {}

    Result<std::uint64_t> count() {
        while (next_line()) {
            TextReader words(line_);
            const std::string_view keyword = words.word();
            if (object_next_ && keyword != "OBJECT") {
                return bad("'OBJECT' should follow the line of 'kids'");
            }
            CD_TRY(read_line(keyword, words));
        }
        CD_TRY(end_surface());
        return triangles_;
    }

  private:
    [[nodiscard]] Error bad(const std::string& detail) const {
        return bad_input(path_.string() + ":" + std::to_string(number_) + ": " + detail);
    }

    /// Moves to the next line that is not empty. A line of blanks is not empty here, since the
    /// importer stops at it.
    bool next_line() {
        while (!rest_.empty()) {
            const std::size_t length = std::min(rest_.find_first_of("\r\n"), rest_.size());
            line_ = rest_.substr(0, length);
            rest_.remove_prefix(length);
            rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
            ++number_;
            if (!line_.empty()) {
                return true;
            }
        }
        return false;
    }

    Status read_line(std::string_view keyword, TextReader& words) {
        if (keyword == "OBJECT") {
            return begin_object();
        }
        if (keyword == "kids") {
            return end_object(words);
        }
        if (keyword == "numvert") {
            return read_vertices(words);
        }
        if (keyword == "numsurf") {
            CD_TRY(read_count(words));
            return Done{};
        }
        if (keyword == "SURF") {
            return begin_surface(words);
        }
        if (keyword == "refs") {
            return read_corners(words);
        }
        if (keyword == "loc" || keyword == "rot") {
            return read_numbers(words, keyword == "loc" ? 3 : 9);
        }
        if (keyword == "subdiv" && words.word() != "0") {
            return bad("a surface to be subdivided; subdivide it where the model was made");
        }
        return Done{};
    }

    Status begin_object() {
        if (object_is_open_) {
            return bad("'OBJECT' before the line of 'kids' that ends the last one");
        }
        if (!kids_left_.empty()) {
            --kids_left_.back();
        }
        object_is_open_ = true;
        object_next_ = false;
        vertices_ = 0;
        return Done{};
    }

    /// Reads a line `kids`, which ends an object and counts the children that follow.
    Status end_object(TextReader& words) {
        const auto kids = CD_TRY(read_count(words));
        if (kids > 0) {
            kids_left_.push_back(kids);
        }
        while (!kids_left_.empty() && kids_left_.back() == 0) {
            kids_left_.pop_back();
        }
        if (kids_left_.size() > limits::mesh_file_depth_max) {
            return bad("objects nested more than " + std::to_string(limits::mesh_file_depth_max) +
                       " deep");
        }
        object_is_open_ = false;
        object_next_ = !kids_left_.empty();
        return end_surface();
    }

    Status read_vertices(TextReader& words) {
        const auto count = CD_TRY(read_count(words));
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!next_line()) {
                return bad("the file ends before its vertices do");
            }
            TextReader numbers(line_);
            const std::string_view first = TextReader(line_).word();
            if (first.empty() || std::string_view("+-0123456789").find(first[0]) == first.npos) {
                return bad("a vertex that begins with '" + std::string(first) +
                           "', which the importer takes for its end; write 0.25 for .25");
            }
            CD_TRY(read_numbers(numbers, 3));
        }
        vertices_ += count;
        return Done{};
    }

    Status begin_surface(TextReader& words) {
        CD_TRY(end_surface());
        const std::string_view word = words.word();
        const auto flags = to_flags(word);
        if (!flags) {
            return bad("a surface whose flags '" + std::string(word) + "' are not a number");
        }
        type_ = static_cast<SurfaceType>(*flags & 0xfu);
        surface_has_no_corners_ = true;
        return Done{};
    }

    Status end_surface() {
        return surface_has_no_corners_ ? Status(bad("the surface before has no corners")) : Done{};
    }

    Status read_corners(TextReader& words) {
        const auto count = CD_TRY(read_count(words));
        const std::uint64_t least = type_ == SurfaceType::Strip ? 3 : 1;
        if (count < least) {
            return bad("a surface of too few corners");
        }
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::string_view word =
                next_line() ? TextReader(line_).word() : std::string_view();
            const auto vertex = to_whole(word);
            if (!vertex || *vertex >= vertices_) {
                return bad("the surface names vertex '" + std::string(word) + "' of " +
                           std::to_string(vertices_));
            }
        }
        const bool is_line = type_ == SurfaceType::ClosedLine || type_ == SurfaceType::OpenLine;
        triangles_ += !is_line && count > 2 ? count - 2 : 0;
        type_ = SurfaceType::Polygon; // For a surface without a line 'SURF'.
        surface_has_no_corners_ = false;
        return Done{};
    }

    Status read_numbers(TextReader& words, int count) {
        for (int i = 0; i < count; ++i) {
            const std::string_view word = words.word();
            if (!to_number(word)) {
                return bad("a coordinate '" + std::string(word) + "' that is not a number");
            }
        }
        return Done{};
    }

    /// Reads a count. Refuses one above the file's size, since the importer allocates that much.
    Result<std::uint64_t> read_count(TextReader& words) {
        const std::string_view word = words.word();
        const auto count = to_whole(word);
        if (!count || *count > text_.size()) {
            return bad("a count of '" + std::string(word) + "'");
        }
        return *count;
    }

    const std::filesystem::path& path_;
    std::string_view text_;
    std::string_view rest_;
    std::string_view line_;
    std::uint64_t number_ = 0; ///< The current line, from 1.
    std::uint64_t triangles_ = 0;

    std::uint64_t vertices_ = 0; ///< Vertices of the current object.
    SurfaceType type_ = SurfaceType::Polygon;
    bool surface_has_no_corners_ = false;
    bool object_is_open_ = false;
    bool object_next_ = false;
    std::vector<std::uint64_t> kids_left_; ///< For each enclosing object: children still to come.
};

} // namespace

bool is_ac3d(const std::filesystem::path& path, const std::string& lower_extension) {
    std::array<char, magic.size()> begin{};
    std::ifstream in(path, std::ios::binary);
    const bool has_magic = in.read(begin.data(), begin.size()) &&
                           std::string_view(begin.data(), begin.size()) == magic;
    return has_magic || lower_extension == ".ac" || lower_extension == ".acc" ||
           lower_extension == ".ac3d";
}

Result<std::uint64_t> count_ac3d_triangles(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    return Ac3dCounter(path, text).count();
}

} // namespace cd
