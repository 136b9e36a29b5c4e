#include "client/poses/label_file.hpp"

#include "client/formats/csv_rows.hpp"
#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace cd {

namespace {

using CsvRow = std::vector<std::string>;

std::string header_of(const LabelColumns& columns) {
    return columns.ids == IdKind::None ? "t" : columns.has_times ? "id,t" : "id";
}

/// Reads a row of fields that `csv_field` wrote. Returns false at the end of the file.
bool read_row(std::istream& in, CsvRow& row) {
    row.assign(1, "");
    bool is_quoted = false;
    char c = 0;
    bool is_any = false;
    while (in.get(c)) {
        is_any = true;
        if (c == '"' && is_quoted && in.peek() == '"') {
            row.back() += static_cast<char>(in.get());
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (c == ',' && !is_quoted) {
            row.emplace_back();
        } else if (c == '\n' && !is_quoted) {
            return true;
        } else {
            row.back() += c;
        }
    }
    return is_any;
}

} // namespace

std::uint64_t label_bytes(const PoseLabels& labels) {
    constexpr std::uint64_t number_bytes = 25; // The length of the longest double and a separator.
    const std::uint64_t numbers = labels.integers.size() + labels.times.size();
    std::uint64_t bytes = sizeof "id,t" + number_bytes * numbers;
    for (const std::string& text : labels.texts) {
        bytes += csv_field(text).size() + 1;
    }
    return labels.is_empty() ? 0 : bytes;
}

Status write_labels(const std::filesystem::path& path, const PoseLabels& labels) {
    const LabelColumns columns = labels.columns();
    auto file = CD_TRY(RowFile::create(path, header_of(columns) + "\n"));
    const std::size_t rows =
        std::max({labels.integers.size(), labels.texts.size(), labels.times.size()});
    for (std::size_t i = 0; i < rows; ++i) {
        std::string row;
        if (columns.ids != IdKind::None) {
            row = columns.ids == IdKind::Integer ? std::to_string(labels.integers[i])
                                                 : csv_field(labels.texts[i]);
        }
        if (columns.has_times) {
            row += (row.empty() && columns.ids == IdKind::None ? "" : ",") +
                   exact_text(labels.times[i]);
        }
        CD_TRY(file.add(std::string_view(row), "\n"));
    }
    return file.commit();
}

Result<PoseLabels> read_labels(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return Error{ErrorCode::NotFound, path.string() + ": no such file"};
    }
    CsvRow header;
    CsvRow row;
    static_cast<void>(read_row(in, header));
    const bool has_ids = header.front() == "id";
    const bool has_times = header.back() == "t";
    bool is_good = header.size() == (has_ids ? 1u : 0u) + (has_times ? 1u : 0u);
    PoseLabels labels;
    while (is_good && read_row(in, row)) {
        is_good = row.size() == header.size();
        if (is_good && has_ids) {
            add_pose_id(labels, row.front());
        }
        if (is_good && has_times) {
            const auto time = number_in<double>(row.back());
            is_good = time && std::isfinite(*time);
            labels.times.push_back(time.value_or(0));
        }
    }
    return is_good ? Result(std::move(labels))
                   : Error{ErrorCode::Io, path.string() + " is damaged"};
}

} // namespace cd
