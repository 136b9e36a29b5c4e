#include "client/import/indexed_mesh.hpp"
#include "client/import/mesh_readers.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <vector>

namespace cd {

namespace {

class OffReader {
  public:
    explicit OffReader(const MeshSource& source)
        : source_(source),
          text_(without_utf8_mark(source.bytes)),
          mesh_(source.options.unit_factor) {}

    Result<ImportedMesh> read() {
        CD_TRY(read_header());
        mesh_.begin_part(nameless_part);
        for (std::uint64_t i = 0; i < vertices_; ++i) {
            CD_TRY(read_vertex(i));
        }
        for (std::uint64_t i = 0; i < faces_; ++i) {
            CD_TRY(read_face(i));
        }
        if (!first_word().empty()) {
            return refusal("has data after the " + std::to_string(faces_) + " faces of its header");
        }
        return mesh_.finish(source_);
    }

  private:
    Error refusal(const std::string& detail) const { return source_.refusal(text_.line(), detail); }

    /// Returns the next word outside of comments, on this line or a later one.
    std::string_view first_word() {
        std::string_view word = text_.word();
        while (word.starts_with('#')) {
            text_.rest_of_line();
            word = text_.word();
        }
        return word;
    }

    /// Returns the next word of this line; empty at the line's end or at a comment.
    std::string_view word_in_line() {
        const std::string_view word = text_.word_in_line();
        if (!word.starts_with('#')) {
            return word;
        }
        text_.rest_of_line();
        return {};
    }

    Status read_header() {
        std::string_view keyword = first_word();
        const std::string whole = in_quotes(keyword);
        for (const std::string_view prefix : {"ST", "C", "N"}) {
            const bool has_prefix = keyword.starts_with(prefix);
            keyword.remove_prefix(has_prefix ? prefix.size() : 0);
            has_more_numbers_ = has_more_numbers_ || has_prefix;
        }
        if (keyword != "OFF") {
            return refusal("begins with " + whole +
                           ", but only OFF, COFF, NOFF, STOFF and their combinations are read");
        }
        const std::string_view word = first_word();
        const auto vertices = to_whole(word);
        const auto faces = to_whole(word_in_line());
        if (!vertices || !faces) {
            return refusal(word == "BINARY" ? "is a binary OFF file; write it as text"
                                            : "has no line with its counts of vertices and faces");
        }
        vertices_ = *vertices;
        faces_ = *faces;
        text_.rest_of_line(); // Skips the count of edges, which may be missing or wrong.
        return Done{};
    }

    Status read_vertex(std::uint64_t number) {
        const auto name = [&] {
            return "vertex " + std::to_string(number) + " of " + std::to_string(vertices_);
        };
        Vec3 vertex;
        std::string_view word = first_word();
        for (double& value : vertex) {
            const auto read = to_number(word);
            if (!read) {
                return refusal(name() + " is missing or is not three numbers");
            }
            value = *read;
            word = word_in_line();
        }
        if (!word.empty() && !has_more_numbers_) {
            return refusal(name() + " has more than three numbers; with colours the file begins "
                                    "with 'COFF', with normals with 'NOFF'");
        }
        if (!vertex.allFinite()) {
            return refusal(name() + " has a coordinate that is not finite");
        }
        text_.rest_of_line();
        mesh_.add_vertex(vertex);
        return Done{};
    }

    Status read_face(std::uint64_t number) {
        const auto name = [&] { return "face " + std::to_string(number); };
        const auto count = to_whole(first_word());
        corners_.clear();
        for (std::uint64_t k = 0; count && k < *count; ++k) {
            const auto corner = number_in<std::int64_t>(word_in_line());
            if (!corner) {
                break;
            }
            corners_.push_back(*corner);
        }
        if (!count || corners_.size() < *count) {
            return refusal(name() + " of " + std::to_string(faces_) + " is missing or damaged");
        }
        text_.rest_of_line(); // Skips a colour.
        const Status added = mesh_.add_face(corners_);
        return added ? Done{} : Status(refusal(name() + " " + added.error().detail));
    }

    const MeshSource& source_;
    TextReader text_;
    IndexedMesh mesh_;
    std::uint64_t vertices_ = 0;        ///< Number of vertices in the header.
    std::uint64_t faces_ = 0;           ///< Number of faces in the header.
    bool has_more_numbers_ = false;     ///< True if normals, colours or texture coordinates follow.
    std::vector<std::int64_t> corners_; ///< Corners of the current face.
};

} // namespace

Result<ImportedMesh> import_off(const MeshSource& source) {
    return OffReader(source).read();
}

} // namespace cd
