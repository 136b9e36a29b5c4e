#include "client/export/result_writer.hpp"
#include "client/formats/csv_rows.hpp"
#include "client/formats/npz.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace cd {

namespace {

Status
write_csv(const ContactMap& map, const std::filesystem::path& path, const ExportContext& context) {
    auto file =
        CD_TRY(RowFile::create(path, "body,triangle," + map_column_name(context) + ",part\n"));
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        PartFields parts(context.bodies[i].mesh);
        const std::string name = csv_field(context.bodies[i].name);
        for (const TriangleContacts& row : map.bodies[i]) {
            CD_TRY(file.add(std::string_view(name),
                            ",",
                            row.triangle,
                            ",",
                            row.scenarios,
                            ",",
                            parts.of(row.triangle),
                            "\n"));
        }
    }
    return file.commit();
}

Status
write_npz(const ContactMap& map, const std::filesystem::path& path, const ExportContext& context) {
    NpzWriter file(path, context.stop);
    if (context.map_pairs() != 0) {
        const std::array<std::uint64_t, 1> pairs{context.map_pairs()};
        const std::size_t array = file.add_array("first_pairs", NpyType::U8);
        CD_TRY(file.append(array, std::span<const std::uint64_t>(pairs)));
    }
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        const std::size_t array = file.add_array(context.bodies[i].name, NpyType::U8, 2);
        for (const TriangleContacts& row : map.bodies[i]) {
            const std::array<std::uint64_t, 2> numbers{row.triangle, row.scenarios};
            CD_TRY(file.append(array, std::span<const std::uint64_t>(numbers)));
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

Status write_map_files(const ContactMap& map,
                       const std::filesystem::path& dir,
                       const std::vector<std::string>& formats,
                       const ExportContext& context) {
    const auto has = [&](std::string_view format) {
        return std::find(formats.begin(), formats.end(), format) != formats.end();
    };
    if (has("npz")) {
        CD_TRY(write_npz(map, dir / "map.npz", context));
        if (!has("csv")) {
            return Done{};
        }
    }
    return write_csv(map, dir / "map.csv", context);
}

} // namespace cd
