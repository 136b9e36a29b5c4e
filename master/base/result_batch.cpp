#include "master/base/result_batch.hpp"

#include "common/core/files/disk_file.hpp"

#include <utility>

namespace cd {

std::uint64_t record_footer(std::uint64_t scenario, std::span<const std::byte> record) {
    return checksum(record) + scenario;
}

void ResultBatch::reserve(std::size_t results, std::size_t record_bytes) {
    rows_.reserve(results);
    stored_.reserve(record_bytes + results * record_footer_bytes);
}

void ResultBatch::add(const ScenarioResult& result) {
    const std::size_t begin = stored_.size();
    put_result(stored_, result);
    finish(result.index, facts_of(result), begin);
}

void ResultBatch::add_settled(const ScenarioResult& result, std::span<const std::byte> record) {
    const std::size_t begin = stored_.size();
    put_settled(stored_, result, record);
    finish(result.index, facts_of(result), begin);
}

void ResultBatch::add(std::uint64_t scenario,
                      const ScenarioFacts& facts,
                      std::span<const std::byte> record) {
    const std::size_t begin = stored_.size();
    put_bytes(stored_, record);
    finish(scenario, facts, begin);
}

void ResultBatch::finish(std::uint64_t scenario, const ScenarioFacts& facts, std::size_t begin) {
    const auto record = std::span(stored()).subspan(begin);
    rows_.push_back({scenario, record.size(), facts});
    if (record.size() > unhashed_record_bytes_max) {
        hashes_.push_back(digest_of_record(record));
    }
    stored_.put(record_footer(scenario, record));
}

std::vector<Sha256> ResultBatch::digests() const {
    std::vector<Sha256> digests;
    digests.reserve(rows_.size());
    auto hash = hashes_.begin();
    for_each([&](const ResultRow&, std::span<const std::byte> record) {
        const bool is_short = record.size() <= unhashed_record_bytes_max;
        digests.push_back(is_short ? digest_of_record(record) : *hash++);
    });
    return digests;
}

ResultBatch ResultBatch::without(std::span<const std::size_t> places) const {
    ResultBatch rest;
    std::size_t place = 0;
    for_each([&](const ResultRow& row, std::span<const std::byte> record) {
        if (!places.empty() && places.front() == place) {
            places = places.subspan(1);
        } else {
            rest.add(row.scenario, row.facts, record);
        }
        ++place;
    });
    return rest;
}

} // namespace cd
