#include "client/export/vtp_file.hpp"

#include "common/core/errors.hpp"
#include "common/core/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace cd {

namespace {

/// Returns a number type's name in VTK's XML.
std::string_view vtk_name(NpyType type) {
    switch (type) {
    case NpyType::F8:
        return "Float64";
    case NpyType::F4:
        return "Float32";
    case NpyType::I8:
        return "Int64";
    case NpyType::I4:
        return "Int32";
    case NpyType::I2:
        return "Int16";
    case NpyType::I1:
        return "Int8";
    case NpyType::U8:
        return "UInt64";
    case NpyType::U4:
        return "UInt32";
    case NpyType::U2:
        return "UInt16";
    case NpyType::U1:
        break;
    }
    return "UInt8";
}

/// Returns the texts one after another, each with a NUL behind it.
std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) {
        for (const char c : valid_utf8(text)) {
            all += c == '\0' ? std::string_view("\xef\xbf\xbd") : std::string_view(&c, 1);
        }
        all += '\0';
    }
    return all;
}

NumberArray bytes_of(std::string text) {
    const std::uint64_t size = text.size();
    return make_numbers<std::uint8_t>(size, [text = std::move(text)](std::uint64_t i) {
        return static_cast<std::uint8_t>(text[i]);
    });
}

/// The XML before the appended data, and the arrays in the order of their blocks in that data. A
/// block is its size in bytes (u64), then its bytes.
class VtpLayout {
  public:
    explicit VtpLayout(const VtpData& data) {
        xml_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
        add_texts(data.texts);
        xml_ += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
                            "NumberOfLines=\"{}\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
                            data.points.count / 3,
                            data.dots.ends.count,
                            data.lines.ends.count,
                            data.triangles.ends.count);
        add_arrays("PointData", data.point_arrays);
        add_arrays("CellData", data.cell_arrays);
        xml_ += "<Points>\n";
        add("Points", data.points, 3);
        xml_ += "</Points>\n";
        add_cells("Verts", data.dots);
        add_cells("Lines", data.lines);
        add_cells("Polys", data.triangles);
        xml_ += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    }

    [[nodiscard]] const std::string& xml() const { return xml_; }
    [[nodiscard]] const std::vector<NumberArray>& blocks() const { return blocks_; }

  private:
    void add_block(NumberArray block) {
        xml_ += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", offset_);
        offset_ += sizeof(std::uint64_t) + block.bytes();
        blocks_.push_back(std::move(block));
    }

    void add(std::string_view name, const NumberArray& numbers, unsigned columns) {
        xml_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"",
                            vtk_name(numbers.type),
                            name,
                            columns);
        add_block(numbers);
    }

    void add_arrays(std::string_view section, const std::vector<VtpArray>& arrays) {
        xml_ += arrays.empty() ? fmt::format("<{}>\n", section)
                               : fmt::format("<{} Scalars=\"{}\">\n", section, arrays[0].name);
        for (const VtpArray& array : arrays) {
            add(array.name, array.numbers, array.columns);
        }
        xml_ += fmt::format("</{}>\n", section);
    }

    void add_cells(std::string_view section, const VtpCells& cells) {
        xml_ += fmt::format("<{}>\n", section);
        add("connectivity", cells.connectivity, 1);
        add("offsets", cells.ends, 1);
        xml_ += fmt::format("</{}>\n", section);
    }

    void add_texts(const std::vector<VtpTexts>& fields) {
        xml_ += "<FieldData>\n";
        for (const VtpTexts& field : fields) {
            xml_ += fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\"",
                                field.name,
                                field.texts.size());
            add_block(bytes_of(joined(field.texts)));
        }
        xml_ += "</FieldData>\n";
    }

    std::string xml_;
    std::vector<NumberArray> blocks_;
    std::uint64_t offset_ = 0;
};

/// Returns `count` cells of `size` points each. `point_at(i)` is the i-th point in all cells; all
/// are below `points_end`.
template <class PointAt>
VtpCells cells_of(std::uint64_t count, unsigned size, std::uint64_t points_end, PointAt point_at) {
    const auto make = [&]<class Index>(Index) {
        return VtpCells{
            make_numbers<Index>(size * count, point_at),
            make_numbers<Index>(count, [size](std::uint64_t i) { return size * (i + 1); })};
    };
    // VTK keeps both arrays in one type, and converts them where they differ.
    const bool fits =
        std::max(points_end, size * count) <= std::numeric_limits<std::int32_t>::max();
    return fits ? make(std::int32_t{}) : make(std::int64_t{});
}

template <class Number>
NumberArray coordinates_as(std::span<const Vec3> points) {
    return make_numbers<Number>(3 * points.size(), [points](std::uint64_t i) {
        return points[i / 3][static_cast<Eigen::Index>(i % 3)];
    });
}

} // namespace

Status write_vtp(const VtpData& data, const std::filesystem::path& path, const StopCheck& stop) {
    const VtpLayout layout(data);
    auto file = CD_TRY(OutputFile::create(path));
    CD_TRY(file.write(layout.xml()));
    for (const NumberArray& block : layout.blocks()) {
        const std::uint64_t bytes = block.bytes();
        CD_TRY(file.write({reinterpret_cast<const char*>(&bytes), sizeof bytes}));
        CD_TRY(write_numbers(block, file, stop));
    }
    CD_TRY(file.write("\n</AppendedData>\n</VTKFile>\n"));
    return file.commit();
}

VtpCells consecutive_cells(std::uint64_t count, unsigned size, std::uint64_t first) {
    return cells_of(
        count, size, first + size * count, [first](std::uint64_t i) { return first + i; });
}

VtpCells triangle_cells(const Mesh& mesh) {
    const std::span<const Triangle> triangles = mesh.triangles();
    return cells_of(triangles.size(), 3, mesh.vertices().size(), [triangles](std::uint64_t i) {
        return triangles[i / 3][i % 3];
    });
}

NumberArray coordinates(std::span<const Vec3> points, NpyType type) {
    return type == NpyType::F4 ? coordinates_as<float>(points) : coordinates_as<double>(points);
}

std::string pvd_text(std::span<const VtpStep> steps) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const VtpStep& step : steps) {
        for (std::size_t part = 0; part < step.files.size(); ++part) {
            text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n",
                                step.time,
                                part,
                                step.files[part]);
        }
    }
    return text + "</Collection>\n</VTKFile>\n";
}

} // namespace cd
