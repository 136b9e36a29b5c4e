#include "client/import/text/text_reader.hpp"
#include "client/poses/csv_columns.hpp"
#include "client/poses/fcd_file.hpp"
#include "client/poses/traffic_builder.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cd {

namespace {

/// The positions of the columns; `no_column` for one that the file does not have.
struct FcdColumns {
    std::string separator;
    std::size_t count = 0;
    std::size_t time = no_column;
    std::array<std::size_t, fcd_attributes.size()> attributes = {};
};

/// Finds a column under its name, or with the name of its element before it. Errors: BadInput for
/// two such columns.
Result<std::size_t> find_column(const std::vector<std::string_view>& names,
                                const std::string& element,
                                std::string_view name,
                                std::uint64_t line) {
    const std::string full = element + "_" + std::string(name);
    const bool is_full = std::ranges::find(names, full) != names.end();
    const std::string_view wanted = is_full ? std::string_view(full) : name;
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) {
        return no_column;
    }
    if (std::find(found + 1, names.end(), wanted) != names.end()) {
        return error_in_line(line, "column '" + std::string(wanted) + "' appears twice");
    }
    return static_cast<std::size_t>(found - names.begin());
}

Error no_such_column(std::uint64_t line, const std::string& name) {
    return error_in_line(line,
                         "there is no column '" + name +
                             "'; SUMO's CSV of FCD has timestep_time, vehicle_id, vehicle_type, "
                             "vehicle_x, vehicle_y and vehicle_angle");
}

Result<FcdColumns> read_header(std::string_view text, std::uint64_t line) {
    FcdColumns columns;
    columns.separator = split_line(text, ";", false).size() > 1 ? ";" : ",";
    const auto names = split_line(text, columns.separator, false);
    columns.count = names.size();
    columns.time = CD_TRY(find_column(names, "timestep", "time", line));
    if (columns.time == no_column) {
        return no_such_column(line, "timestep_time");
    }
    for (std::size_t i = 0; i < fcd_attributes.size(); ++i) {
        columns.attributes[i] = CD_TRY(find_column(names, "vehicle", fcd_attributes[i], line));
        if (columns.attributes[i] == no_column && i < fcd_attributes_needed) {
            return no_such_column(line, "vehicle_" + std::string(fcd_attributes[i]));
        }
    }
    return columns;
}

/// Adds the vehicle of a row, and begins a step if the row has another time.
Status add_row(TrafficBuilder& builder,
               const FcdColumns& columns,
               std::string_view text,
               std::uint64_t line) {
    const auto words = split_line(text, columns.separator, false);
    if (words.size() != columns.count) {
        return error_in_line(line,
                             std::to_string(words.size()) + " values, but the first line names " +
                                 std::to_string(columns.count));
    }
    const auto time = to_number(words[columns.time]);
    if (!time || !builder.time() || *time != *builder.time()) {
        CD_TRY(builder.begin_step(words[columns.time], line));
    }
    FcdTexts texts;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (columns.attributes[i] != no_column && !words[columns.attributes[i]].empty()) {
            texts[i] = words[columns.attributes[i]];
        }
    }
    return texts[0] ? builder.add(texts, line) : Status(Done{});
}

} // namespace

Result<RoadTraffic> read_fcd_csv(std::istream& in, const FcdSpec& spec) {
    TrafficBuilder builder(spec);
    std::optional<FcdColumns> columns;
    std::string line;
    std::uint64_t number = 0;
    while (std::getline(in, line)) {
        ++number;
        const std::string_view text = number == 1 ? without_utf8_mark(line) : line;
        if (is_comment(text)) {
            continue;
        }
        if (columns) {
            CD_TRY(add_row(builder, *columns, text, number));
        } else {
            columns = CD_TRY(read_header(text, number));
        }
    }
    if (in.bad()) {
        return Error{ErrorCode::Io, "cannot be read beyond line " + std::to_string(number)};
    }
    return columns ? builder.finish() : bad_input("there is no line that names the columns");
}

} // namespace cd
