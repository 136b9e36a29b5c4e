#include "client/export/map_files.hpp"

#include "client/base/words.hpp"
#include "client/formats/csv_rows.hpp"
#include "client/formats/npz.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace cd {

namespace {

Status
write_csv(const ContactMap& map, const std::filesystem::path& path, const ExportContext& context) {
    const std::string scenarios =
        context.map_pairs == 0
            ? "scenarios"
            : "scenarios_of_first_" + std::to_string(context.map_pairs) + "_pairs";
    auto file = RowFile::create(path, "body,triangle," + scenarios + ",part\n");
    if (!file) {
        return file.error();
    }
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        PartFields parts(context.bodies[i].mesh);
        const std::string name = csv_field(context.bodies[i].name);
        for (const TriangleContacts& row : map.bodies[i]) {
            const Status added = file.value().add(std::string_view(name),
                                                  ",",
                                                  row.triangle,
                                                  ",",
                                                  row.scenarios,
                                                  ",",
                                                  parts.of(row.triangle),
                                                  "\n");
            if (!added) {
                return added;
            }
        }
    }
    return file.value().commit();
}

Status
write_npz(const ContactMap& map, const std::filesystem::path& path, const ExportContext& context) {
    NpzWriter file(path, context.stop);
    if (context.map_pairs != 0) {
        const std::array<std::uint64_t, 1> pairs{context.map_pairs};
        const std::size_t array = file.add_array("first_pairs", NpyType::U8);
        if (Status added = file.append(array, std::span<const std::uint64_t>(pairs)); !added) {
            return added;
        }
    }
    for (std::size_t i = 0; i < map.bodies.size(); ++i) {
        const std::size_t array = file.add_array(context.bodies[i].name, NpyType::U8, 2);
        for (const TriangleContacts& row : map.bodies[i]) {
            const std::array<std::uint64_t, 2> numbers{row.triangle, row.scenarios};
            if (Status added = file.append(array, std::span<const std::uint64_t>(numbers));
                !added) {
                return added;
            }
        }
    }
    return file.finish();
}

} // namespace

Status write_map_files(const ContactMap& map,
                       const std::filesystem::path& dir,
                       const std::vector<std::string>& formats,
                       const ExportContext& context) {
    const auto has = [&](std::string_view format) {
        return std::find(formats.begin(), formats.end(), format) != formats.end();
    };
    if (has("npz")) {
        if (Status written = write_npz(map, dir / "map.npz", context); !written) {
            return written;
        }
        if (!has("csv")) {
            return Done{};
        }
    }
    return write_csv(map, dir / "map.csv", context);
}

} // namespace cd
