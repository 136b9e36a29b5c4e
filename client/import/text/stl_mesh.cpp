#include "client/import/mesh_builder.hpp"
#include "client/import/mesh_readers.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little, "binary files are little-endian");

namespace cd {

namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;
constexpr std::size_t normal_bytes = 12;
constexpr int normal_words = 4; // "normal" and three numbers.

std::uint64_t facets_counted(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
    return count;
}

bool is_text(std::string_view bytes) {
    if (bytes.size() >= header_bytes &&
        bytes.size() == header_bytes + facet_bytes * facets_counted(bytes)) {
        return false;
    }
    const std::string_view begin = bytes.substr(0, header_bytes);
    return equals_lower(TextReader(without_utf8_mark(begin)).word(), "solid") &&
           begin.find('\0') == begin.npos;
}

class BinaryStl {
  public:
    explicit BinaryStl(const MeshSource& source) : source_(source) {}

    Result<ImportedMesh> read() {
        const std::uint64_t count = facets_counted(source_.bytes);
        const std::uint64_t room = (source_.bytes.size() - header_bytes) / facet_bytes;
        if (room < count) {
            return source_.refusal("is cut short: it counts " + std::to_string(count) +
                                   " facets and holds " + std::to_string(room));
        }
        builder_.begin_part(nameless_part);
        for (std::uint64_t i = 0; i < count; ++i) {
            CD_TRY(add_facet(i));
        }
        return finish(count);
    }

  private:
    Status add_facet(std::uint64_t number) {
        const std::size_t at = header_bytes + facet_bytes * number;
        std::array<float, 9> values{};
        std::memcpy(values.data(), source_.bytes.data() + at + normal_bytes, sizeof values);
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Vector3f corner(values[3 * k], values[3 * k + 1], values[3 * k + 2]);
            corners[k] = source_.options.unit_factor * corner.cast<double>();
            if (!corners[k].allFinite()) {
                return source_.refusal("facet " + std::to_string(number) + " (byte " +
                                       std::to_string(at) +
                                       ") has a coordinate that is not finite");
            }
        }
        builder_.add(corners);
        return Done{};
    }

    Result<ImportedMesh> finish(std::uint64_t count) {
        const std::string_view after =
            source_.bytes.substr(header_bytes + facet_bytes * static_cast<std::size_t>(count));
        const bool is_padding = after.find_first_not_of('\0') == after.npos;
        const std::string both = std::to_string(after.size()) + " bytes after the " +
                                 std::to_string(count) + " facets that it counts";
        if (after.size() >= facet_bytes && !is_padding) {
            return source_.refusal("has " + both + "; its count is damaged, or it holds more");
        }
        auto imported = finish_import(source_.path, builder_);
        if (imported && !after.empty()) {
            imported.value().warnings.push_back(source_.path.string() + ": " + both +
                                                " are not read");
        }
        return imported;
    }

    const MeshSource& source_;
    MeshBuilder builder_;
};

class TextStl {
  public:
    explicit TextStl(const MeshSource& source)
        : source_(source), text_(without_utf8_mark(source.bytes)) {}

    Result<ImportedMesh> read() {
        for (auto word = text_.word(); !word.empty(); word = text_.word()) {
            if (equals_lower(word, "solid")) {
                CD_TRY(read_solid());
            }
            CD_TRY(skip_line(word));
        }
        return finish_import(source_.path, builder_);
    }

  private:
    Error refusal(const std::string& detail) const { return source_.refusal(text_.line(), detail); }

    /// Reads a solid from behind its word "solid" to its "endsolid".
    Status read_solid() {
        const std::uint64_t begin = text_.line();
        bool has_facet = read_name();
        while (true) {
            if (has_facet) {
                CD_TRY(read_facet());
            }
            const std::string_view word = text_.word();
            if (equals_lower(word, "endsolid")) {
                return Done{};
            }
            has_facet = equals_lower(word, "facet");
            if (word.empty()) {
                return refusal("the file ends within the solid of line " + std::to_string(begin) +
                               ", without 'endsolid'");
            }
            if (!has_facet) {
                return refusal(in_quotes(word) + " in place of 'facet' or 'endsolid'");
            }
        }
    }

    /// Skips the rest of a line between two solids; `word` is its first word.
    Status skip_line(std::string_view word) {
        for (; !word.empty(); word = text_.word_in_line()) {
            if (equals_lower(word, "facet") || equals_lower(word, "vertex")) {
                return refusal(in_quotes(word) + " outside of a solid");
            }
        }
        return Done{};
    }

    /// Reads the solid's name and begins a part. True if its first facet begins on that line.
    bool read_name() {
        const std::string_view line = TextReader(text_).rest_of_line();
        TextReader words = text_;
        for (auto word = words.word_in_line(); !word.empty(); word = words.word_in_line()) {
            TextReader after = words;
            if (equals_lower(word, "facet") && equals_lower(after.word_in_line(), "normal")) {
                const auto length = static_cast<std::size_t>(word.data() - line.data());
                begin_part(TextReader(line.substr(0, length)).rest_of_line());
                text_ = words;
                return true;
            }
        }
        begin_part(text_.rest_of_line());
        return false;
    }

    void begin_part(std::string_view name) {
        builder_.begin_part(name.empty() ? nameless_part : std::string(name));
    }

    /// Reads a facet from behind its word "facet" to its "endfacet".
    Status read_facet() {
        auto word = text_.word();
        for (int i = 0; i < normal_words && !equals_lower(word, "outer"); ++i) {
            word = text_.word();
        }
        if (!equals_lower(word, "outer") || !equals_lower(text_.word(), "loop")) {
            return refusal("a facet without 'outer loop'");
        }
        Corners corners;
        for (Vec3& corner : corners) {
            if (!equals_lower(text_.word(), "vertex")) {
                return refusal("a facet without three vertices");
            }
            CD_TRY(read_vertex(corner));
        }
        word = text_.word();
        if (equals_lower(word, "vertex")) {
            return refusal("a facet of more than three vertices");
        }
        if (!equals_lower(word, "endloop") || !equals_lower(text_.word(), "endfacet")) {
            return refusal("a facet without 'endloop' and 'endfacet'");
        }
        builder_.add(corners);
        return Done{};
    }

    Status read_vertex(Vec3& corner) {
        for (double& value : corner) {
            const std::string_view word = text_.word();
            const auto number = to_number(word);
            if (!number) {
                return refusal("a vertex whose coordinate " + in_quotes(word) + " is not a number");
            }
            value = source_.options.unit_factor * *number;
        }
        return corner.allFinite() ? Status(Done{})
                                  : refusal("a vertex with a coordinate that is not finite");
    }

    const MeshSource& source_;
    TextReader text_;
    MeshBuilder builder_;
};

} // namespace

Result<ImportedMesh> import_stl(const MeshSource& source) {
    if (is_text(source.bytes)) {
        return TextStl(source).read();
    }
    if (source.bytes.size() < header_bytes) {
        return source.refusal("is no STL file: it does not begin with 'solid', and has fewer bytes "
                              "than a binary one");
    }
    return BinaryStl(source).read();
}

} // namespace cd
