#include "client/import/indexed_mesh.hpp"
#include "client/import/mesh_readers.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

namespace cd {

namespace {

/// Statements that are skipped, since they give no vertices, faces, lines, points or parts.
constexpr std::array<std::string_view, 16> passed_over{"vn",
                                                       "vt",
                                                       "vp",
                                                       "s",
                                                       "mg",
                                                       "mtllib",
                                                       "usemap",
                                                       "maplib",
                                                       "bevel",
                                                       "lod",
                                                       "c_interp",
                                                       "d_interp",
                                                       "shadow_obj",
                                                       "trace_obj",
                                                       "ctech",
                                                       "stech"};

/// The name of the part that holds elements before any `o` or `g`.
constexpr const char* default_object = "defaultobject";

class ObjReader {
  public:
    explicit ObjReader(const MeshSource& source)
        : source_(source),
          text_(without_utf8_mark(source.bytes), TextReader::Backslash::JoinsLines),
          mesh_(source.options.unit_factor) {}

    Result<ImportedMesh> read() {
        for (auto word = text_.word(); !word.empty(); word = text_.word()) {
            CD_TRY(read_statement(word));
            if (free_text_.ends_with('\\')) {
                return refusal("a comment or name that ends with a backslash; remove it, since "
                               "programs differ in whether it joins the next line");
            }
        }
        return mesh_.finish(source_);
    }

  private:
    Error refusal(const std::string& detail) const { return source_.refusal(text_.line(), detail); }

    Status read_statement(std::string_view keyword) {
        if (keyword == "v") {
            return read_vertex();
        }
        if (keyword == "f" || keyword == "l" || keyword == "p") {
            return read_element(keyword[0]);
        }
        if (keyword == "o" || keyword == "g" || keyword == "usemtl") {
            return read_name(keyword);
        }
        const bool is_comment = keyword.starts_with('#');
        const bool is_known =
            is_comment ||
            std::find(passed_over.begin(), passed_over.end(), keyword) != passed_over.end();
        if (!is_known) {
            return refusal(in_quotes(keyword) +
                           " is no statement that is read here: polygons (v, f), lines, points, "
                           "objects, groups and materials are");
        }
        return is_comment ? pass_comment(keyword) : pass_statement();
    }

    Status pass_comment(std::string_view word) {
        free_text_ = text_.rest_of_line();
        free_text_ = free_text_.empty() ? word : free_text_;
        return Done{};
    }

    Status pass_statement() {
        while (!text_.word_in_line().empty()) {
        }
        return Done{};
    }

    /// Reads a vertex: three coordinates, then optionally a weight of 1 or a colour.
    Status read_vertex() {
        std::array<double, 6> numbers{};
        std::size_t count = 0;
        for (auto word = next_value(); !word.empty(); word = next_value()) {
            const auto number = to_number(word);
            if (!number) {
                return refusal("a vertex whose coordinate " + in_quotes(word) + " is not a number");
            }
            if (count < numbers.size()) {
                numbers[count] = *number;
            }
            ++count;
        }
        if (count != 3 && count != 6 && (count != 4 || numbers[3] != 1)) {
            return refusal("a vertex of " + std::to_string(count) +
                           " numbers; it has three, a fourth that is 1, or six with its colour");
        }
        const Vec3 vertex(numbers[0], numbers[1], numbers[2]);
        if (!vertex.allFinite()) {
            return refusal("a vertex with a coordinate that is not finite");
        }
        mesh_.add_vertex(vertex);
        return Done{};
    }

    /// Returns the next word of a statement; empty at its end or at a comment.
    std::string_view next_value() {
        const std::string_view word = text_.word_in_line();
        return word.starts_with('#') && pass_comment(word) ? std::string_view() : word;
    }

    /// Reads the vertices of a face (`f`), a line (`l`) or points (`p`).
    Status read_element(char kind) {
        corners_.clear();
        for (auto word = next_value(); !word.empty(); word = next_value()) {
            const auto corner = to_corner(word);
            if (!corner) {
                return refusal("the face names vertex " + in_quotes(word) + " of " +
                               std::to_string(mesh_.vertex_count()));
            }
            corners_.push_back(*corner);
        }
        if (corners_.empty()) {
            return refusal("'" + std::string(1, kind) + "' without a vertex");
        }
        begin_default_object();
        part_has_elements_ = true;
        if (kind != 'f') {
            kind == 'l' ? mesh_.skip_lines(corners_.size() - 1)
                        : mesh_.skip_points(corners_.size());
            return Done{};
        }
        const Status added = mesh_.add_face(corners_);
        return added ? Done{} : Status(refusal("the face " + added.error().detail));
    }

    /// Returns the index of a vertex, from 0. The word is "3", "3/1", "3//1" or "3/1/1"; its first
    /// number counts from 1, or backwards from the last vertex if it is negative.
    std::optional<std::int64_t> to_corner(std::string_view word) const {
        std::int64_t number = 0;
        const char* const end = word.data() + word.size();
        const auto [behind, error] = std::from_chars(word.data(), end, number);
        const auto count = static_cast<std::int64_t>(mesh_.vertex_count());
        const bool is_number = error == std::errc{} && (behind == end || *behind == '/');
        if (!is_number || number == 0 || number > count || number < -count) {
            return std::nullopt;
        }
        return number > 0 ? number - 1 : count + number;
    }

    Status read_name(std::string_view keyword) {
        free_text_ = text_.rest_of_line();
        const std::string name(free_text_);
        if (keyword == "o") {
            begin_object(name);
        } else if (keyword == "g" && name != group_) {
            begin_object(name);
            group_ = name;
        } else if (keyword == "usemtl" && !name.empty() && material_ != name) {
            use_material(name);
        }
        return Done{};
    }

    void begin_object(const std::string& name) {
        begin_part(name.empty() ? nameless_part : name);
        has_object_ = true;
        part_has_material_ = material_.has_value();
    }

    void begin_default_object() {
        if (!has_object_) {
            begin_object(default_object);
        }
    }

    void use_material(const std::string& name) {
        material_ = name;
        if (part_has_material_ && part_has_elements_) {
            begin_part(group_.empty() ? name : group_);
        }
        part_has_material_ = true;
    }

    void begin_part(const std::string& name) {
        mesh_.begin_part(name);
        part_has_elements_ = false;
    }

    const MeshSource& source_;
    TextReader text_;
    IndexedMesh mesh_;
    std::vector<std::int64_t> corners_; ///< Vertex indices of the current face, line or points.
    std::string_view free_text_;        ///< The last comment or name.
    std::string group_;
    std::optional<std::string> material_;
    bool has_object_ = false;
    bool part_has_elements_ = false;
    bool part_has_material_ = false;
};

} // namespace

Result<ImportedMesh> import_obj(const MeshSource& source) {
    return ObjReader(source).read();
}

} // namespace cd
