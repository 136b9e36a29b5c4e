#include "client/import/indexed_mesh.hpp"
#include "client/import/mesh_readers.hpp"
#include "client/import/text/ply_header.hpp"
#include "client/import/text/ply_values.hpp"
#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cd {

namespace {

bool is_index_list(const PlyProperty& property) {
    return property.name == "vertex_indices" || property.name == "vertex_index";
}

bool is_coordinate(const PlyProperty& property) {
    const bool has_name = property.name == "x" || property.name == "y" || property.name == "z";
    return has_name && !property.count_type;
}

Status check_vertices(const PlyElement& element, const MeshSource& source) {
    for (const char* name : {"x", "y", "z"}) {
        const auto has_name = [name](const PlyProperty& p) {
            return p.name == name && is_coordinate(p);
        };
        if (std::count_if(element.properties.begin(), element.properties.end(), has_name) != 1) {
            return source.refusal(std::string("its vertices need one property ") + name);
        }
    }
    return Done{};
}

Status check_faces(const PlyElement& element, const MeshSource& source) {
    const auto& properties = element.properties;
    const auto list = std::find_if(properties.begin(), properties.end(), is_index_list);
    const bool is_one = list != properties.end() && list->count_type && is_integer(list->type) &&
                        std::count_if(properties.begin(), properties.end(), is_index_list) == 1;
    return is_one ? Status(Done{})
                  : source.refusal("its element '" + element.name +
                                   "' needs one list of whole numbers 'vertex_indices'");
}

bool has_faces(const PlyElement& element) {
    return element.name == "face" || element.name == "tristrips";
}

/// Checks that the header describes exactly one mesh. Errors: BadInput naming the file.
Status check_header(const PlyHeader& header, const MeshSource& source) {
    const auto& elements = header.elements;
    for (const char* name : {"vertex", "face", "tristrips"}) {
        const auto has_name = [name](const PlyElement& e) { return e.name == name; };
        if (std::count_if(elements.begin(), elements.end(), has_name) > 1) {
            return source.refusal(std::string("its header has two elements '") + name + "'");
        }
    }
    bool has_vertices = false;
    for (const PlyElement& element : elements) {
        if (element.name == "vertex") {
            has_vertices = true;
            CD_TRY(check_vertices(element, source));
        } else if (has_faces(element)) {
            if (!has_vertices) {
                return source.refusal("its header has '" + element.name + "' before 'vertex'");
            }
            CD_TRY(check_faces(element, source));
        }
    }
    return Done{};
}

template <class Values>
class PlyReader {
  public:
    PlyReader(const MeshSource& source, const PlyHeader& header)
        : source_(source),
          header_(header),
          values_(source, header),
          mesh_(source.options.unit_factor) {}

    Result<ImportedMesh> read() {
        mesh_.begin_part(nameless_part);
        for (const PlyElement& element : header_.elements) {
            CD_TRY(read_elements(element));
        }
        if (!values_.is_at_end()) {
            return values_.refusal("has data after the elements of its header");
        }
        return mesh_.finish(source_);
    }

  private:
    Status read_elements(const PlyElement& element) {
        if (element.properties.empty()) {
            return Done{};
        }
        if (!values_.has_room_for(element)) {
            return values_.refusal("is cut short: its header counts " +
                                   std::to_string(element.count) + " of " +
                                   in_quotes(element.name) + ", for which it has too few bytes");
        }
        for (number_ = 0; number_ < element.count; ++number_) {
            if (!values_.begin_element()) {
                return values_.refusal("is cut short: " + name_of(element) + " of " +
                                       std::to_string(element.count) + " is missing");
            }
            CD_TRY(read_element(element));
            if (!values_.end_element()) {
                return values_.refusal(name_of(element) + " has more numbers than its properties");
            }
        }
        return Done{};
    }

    std::string name_of(const PlyElement& element) const {
        const bool is_known = element.name == "vertex" || has_faces(element);
        return (is_known ? element.name : in_quotes(element.name)) + " " + std::to_string(number_);
    }

    Error no_number(const PlyElement& element) const { return values_.no_number(name_of(element)); }

    Status read_element(const PlyElement& element) {
        if (element.name == "vertex") {
            return read_vertex(element);
        }
        if (has_faces(element)) {
            return read_face(element);
        }
        for (const PlyProperty& property : element.properties) {
            if (!skip(property)) {
                return no_number(element);
            }
        }
        return Done{};
    }

    bool skip(const PlyProperty& property) {
        if (!property.count_type) {
            return values_.skip(property.type);
        }
        const auto count = values_.integer(*property.count_type);
        for (std::int64_t i = 0; count && i < *count; ++i) {
            if (!values_.skip(property.type)) {
                return false;
            }
        }
        return count && *count >= 0;
    }

    Status read_vertex(const PlyElement& element) {
        Vec3 vertex = Vec3::Zero();
        for (const PlyProperty& property : element.properties) {
            if (!is_coordinate(property)) {
                if (!skip(property)) {
                    return no_number(element);
                }
                continue;
            }
            const auto value = values_.number(property.type);
            if (!value) {
                return no_number(element);
            }
            vertex[property.name[0] - 'x'] = *value;
        }
        if (!vertex.allFinite()) {
            return values_.refusal(name_of(element) + " has a coordinate that is not finite");
        }
        mesh_.add_vertex(vertex);
        return Done{};
    }

    Status read_face(const PlyElement& element) {
        for (const PlyProperty& property : element.properties) {
            const bool taken = is_index_list(property) ? read_corners(property) : skip(property);
            if (!taken) {
                return no_number(element);
            }
        }
        const Status added = element.name == "face" ? mesh_.add_face(corners_) : add_strip();
        return added ? Status(Done{})
                     : values_.refusal(name_of(element) + " " + added.error().detail);
    }

    bool read_corners(const PlyProperty& property) {
        corners_.clear();
        const auto count = values_.integer(*property.count_type);
        for (std::int64_t i = 0; count && i < *count; ++i) {
            const auto corner = values_.integer(property.type);
            if (!corner) {
                return false;
            }
            corners_.push_back(*corner);
        }
        return count && *count >= 0;
    }

    Status add_strip() {
        std::size_t begin = 0; // Start of the current strip.
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            if (corners_[i] == -1) {
                begin = i + 1;
            } else if (i >= begin + 2) {
                const bool is_turned = (i - begin) % 2 == 1;
                const std::array<std::int64_t, 3> triangle{corners_[i - (is_turned ? 1 : 2)],
                                                           corners_[i - (is_turned ? 2 : 1)],
                                                           corners_[i]};
                CD_TRY(mesh_.add_face(triangle));
            }
        }
        return Done{};
    }

    const MeshSource& source_;
    const PlyHeader& header_;
    Values values_;
    IndexedMesh mesh_;
    std::vector<std::int64_t> corners_; ///< Corners of the current face or strip.
    std::uint64_t number_ = 0;          ///< Index of the current element.
};

} // namespace

Result<ImportedMesh> import_ply(const MeshSource& source) {
    const auto header = CD_TRY(read_ply_header(source));
    CD_TRY(check_header(header, source));
    if (header.format == PlyFormat::Text) {
        return PlyReader<PlyText>(source, header).read();
    }
    return PlyReader<PlyBinary>(source, header).read();
}

} // namespace cd
