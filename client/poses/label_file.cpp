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

constexpr std::string_view end_header = "t_end";

CsvRow header_of(const LabelColumns& columns) {
    CsvRow header;
    if (columns.ids != IdKind::None) {
        header.emplace_back("id");
    }
    if (columns.has_times) {
        header.emplace_back("t");
    }
    if (columns.has_end_times) {
        header.emplace_back(end_header);
    }
    return header;
}

std::string row_text(const CsvRow& row) {
    std::string text;
    for (const std::string& field : row) {
        text += (&field == &row.front() ? "" : ",") + field;
    }
    return text;
}

/// Adds the times of a row from its field number `field` on. Returns false if one is no number.
bool add_times(const CsvRow& row, std::size_t field, PoseLabels& labels) {
    for (std::vector<double>* times : {&labels.times, &labels.end_times}) {
        if (field == row.size()) {
            return true;
        }
        const auto time = number_in<double>(row[field++]);
        if (!time || !std::isfinite(*time)) {
            return false;
        }
        times->push_back(*time);
    }
    return true;
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
    const std::uint64_t numbers =
        labels.integers.size() + labels.times.size() + labels.end_times.size();
    std::uint64_t bytes = sizeof "id,t,t_end" + number_bytes * numbers;
    for (const std::string& text : labels.texts) {
        bytes += csv_field(text).size() + 1;
    }
    return labels.is_empty() ? 0 : bytes;
}

Status write_labels(const std::filesystem::path& path, const PoseLabels& labels) {
    const LabelColumns columns = labels.columns();
    auto file = CD_TRY(RowFile::create(path, row_text(header_of(columns)) + "\n"));
    const std::size_t rows =
        std::max({labels.integers.size(), labels.texts.size(), labels.times.size()});
    for (std::size_t i = 0; i < rows; ++i) {
        CsvRow row;
        if (columns.ids != IdKind::None) {
            row.push_back(columns.ids == IdKind::Integer ? std::to_string(labels.integers[i])
                                                         : csv_field(labels.texts[i]));
        }
        if (columns.has_times) {
            row.push_back(exact_text(labels.times[i]));
        }
        if (columns.has_end_times) {
            row.push_back(exact_text(labels.end_times[i]));
        }
        const std::string text = row_text(row);
        CD_TRY(file.add(std::string_view(text), "\n"));
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
    const bool has_ends = header.back() == end_header;
    const bool has_times = has_ends || header.back() == "t";
    LabelColumns columns{has_ids ? IdKind::Text : IdKind::None, has_times, has_ends};
    bool is_good = header == header_of(columns);
    PoseLabels labels;
    while (is_good && read_row(in, row)) {
        is_good = row.size() == header.size();
        if (is_good && has_ids) {
            add_pose_id(labels, row.front());
        }
        is_good = is_good && add_times(row, has_ids ? 1 : 0, labels);
    }
    return is_good ? Result(std::move(labels))
                   : Error{ErrorCode::Io, path.string() + " is damaged"};
}

} // namespace cd
