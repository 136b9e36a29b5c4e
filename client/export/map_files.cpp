#include "client/export/result_writer.hpp"
#include "client/formats/array_file.hpp"
#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace cd {

namespace {

/// Finds the numbers of triangles that are asked for in ascending order.
class AscendingRows {
  public:
    explicit AscendingRows(std::span<const TriangleContacts> rows) : rows_(rows) {}

    /// Returns the scenarios of a triangle; 0 if it has no row.
    [[nodiscard]] std::uint64_t of(std::uint32_t triangle) {
        while (!rows_.empty() && rows_.front().triangle < triangle) {
            rows_ = rows_.subspan(1);
        }
        const bool is_found = !rows_.empty() && rows_.front().triangle == triangle;
        return is_found ? rows_.front().scenarios : 0;
    }

  private:
    std::span<const TriangleContacts> rows_;
};

/// Returns the contacts of a body; none if they are unknown.
AscendingRows contacts_of(const ExportMap& map, std::size_t body) {
    return AscendingRows(map.contacts
                             ? std::span<const TriangleContacts>(map.contacts->bodies[body])
                             : std::span<const TriangleContacts>());
}

Status
write_csv(const ExportMap& map, const std::filesystem::path& path, const ExportContext& context) {
    const std::string in_contact = map.contacts ? ",in_contact" : "";
    auto file = CD_TRY(RowFile::create(
        path, "body,triangle," + map_column_name(context) + in_contact + ",part\n"));
    for (std::size_t i = 0; i < map.map.bodies.size(); ++i) {
        PartFields parts(context.bodies[i].mesh);
        AscendingRows contacts = contacts_of(map, i);
        const std::string name = csv_field(context.bodies[i].name);
        for (const TriangleContacts& row : map.map.bodies[i]) {
            CD_TRY(file.add(std::string_view(name), ",", row.triangle, ",", row.scenarios));
            if (map.contacts) {
                CD_TRY(file.add(",", contacts.of(row.triangle)));
            }
            CD_TRY(file.add(",", parts.of(row.triangle), "\n"));
        }
    }
    return file.commit();
}

Status write_arrays(const ExportMap& map, ArrayFile& file, const ExportContext& context) {
    if (context.map_pairs() != 0) {
        const std::array<std::uint64_t, 1> pairs{context.map_pairs()};
        const std::size_t array = file.add_array({"first_pairs", NpyType::U8});
        CD_TRY(file.append(array, std::span<const std::uint64_t>(pairs)));
    }
    const std::size_t columns = map.contacts ? 3 : 2;
    for (std::size_t i = 0; i < map.map.bodies.size(); ++i) {
        AscendingRows contacts = contacts_of(map, i);
        const std::size_t array = file.add_array({context.bodies[i].name, NpyType::U8, columns});
        for (const TriangleContacts& row : map.map.bodies[i]) {
            const std::array<std::uint64_t, 3> numbers{
                row.triangle, row.scenarios, contacts.of(row.triangle)};
            CD_TRY(file.append(array, std::span<const std::uint64_t>(numbers).first(columns)));
        }
    }
    return file.finish();
}

} // namespace

std::string map_column_name(const ExportContext& context) {
    return context.map_pairs() == 0
               ? "scenarios"
               : "scenarios_of_first_" + std::to_string(context.map_pairs()) + "_pairs";
}

Status write_map_files(const ExportMap& map,
                       const std::filesystem::path& dir,
                       const std::vector<std::string>& formats,
                       const ExportContext& context) {
    const auto has = [&](std::string_view format) {
        return std::find(formats.begin(), formats.end(), format) != formats.end();
    };
    bool has_arrays = false;
    for (const std::string_view format : array_formats) {
        if (has(format)) {
            const auto file = make_array_file(format, dir, "map", context.stop);
            CD_TRY(write_arrays(map, *file, context));
            has_arrays = true;
        }
    }
    return has_arrays && !has("csv") ? Status(Done{}) : write_csv(map, dir / "map.csv", context);
}

} // namespace cd
