#include "client/folder/run_manifest.hpp"
#include "client/poses/label_file.hpp"
#include "common/job/result/record_file.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <cmath>

namespace cd::fuzz {

namespace {

constexpr std::size_t header_bytes = 2 * word;
constexpr std::size_t block_header_bytes = 3 * word;
constexpr std::size_t footer_bytes = 4 * word;

/// Corrects the checksums of a block file, as far as its sizes can be followed.
void sum_up_blocks(Bytes& file) {
    std::size_t at = header_bytes;
    while (file.size() >= at + block_header_bytes + word) {
        const std::uint64_t bytes = word_at(file, at + 2 * word);
        if (bytes > file.size() - at - block_header_bytes - word) {
            break;
        }
        const std::size_t end = at + block_header_bytes + bytes;
        sum_up(file, at, end, end);
        at = end + word;
    }
    if (file.size() < header_bytes + footer_bytes) {
        return;
    }
    const std::size_t footer = file.size() - footer_bytes;
    const std::uint64_t rows = word_at(file, footer);
    if (rows <= (footer - header_bytes) / (4 * word)) {
        sum_up(file, footer - rows * 4 * word, footer + 2 * word, footer + 2 * word);
    }
}

/// Requires the readable records to ascend and to be canonical. Returns their number if all can be
/// read.
void check_records(const Result<RecordFile>& file) {
    if (!file) {
        return require_reason(file.error());
    }
    std::uint64_t count = 0;
    std::uint64_t index_min = 0;
    const Status read = file.value().for_each([&](const RecordView& record) -> Status {
        require(record.result.index >= index_min, "records ascend");
        require(std::ranges::equal(encode_result(record.result), record.bytes),
                "records are canonical");
        index_min = record.result.index + 1;
        ++count;
        return Done{};
    });
    require(!read || count == file.value().count(), "as many are read as the file says");
}

} // namespace

void record_file(Input input) {
    const Input rest = rest_of(input);
    Bytes bytes(rest.begin(), rest.end());
    if (is_odd(input)) {
        sum_up_blocks(bytes);
    }
    const MemoryFile file(bytes);
    check_records(RecordFile::open(file.path()));
    check_records(RecordFile::open_unfinished(file.path()));
}

void run_json(Input input) {
    const auto manifest = parse_manifest(text_of(input));
    if (!manifest) {
        return require_reason(manifest.error());
    }
    const std::string text = manifest_json(manifest.value());
    const auto again = parse_manifest(text);
    require(again && manifest_json(again.value()) == text, "a manifest's text is one of the same");
    require(is_same_job(again.value(), again.value()) || !again.value().poses.hash,
            "a run is of its own job");
}

void labels(Input input) {
    const MemoryFile file(input);
    const auto read = read_labels(file.path());
    if (!read) {
        return require_reason(read.error());
    }
    const PoseLabels& labels = read.value();
    const std::size_t rows =
        std::max({labels.integers.size(), labels.texts.size(), labels.times.size()});
    require(labels.columns().fit(labels, rows), "every column has an entry for each scenario");
    require(std::ranges::all_of(labels.times, [](double time) { return std::isfinite(time); }),
            "times are finite, as in pose files");
}

} // namespace cd::fuzz
