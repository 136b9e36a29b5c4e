#include "master/base/result_batch.hpp"

#include "common/core/files/disk_file.hpp"

#include <algorithm>
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
    hash();
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
    hash();
}

void ResultBatch::finish(std::uint64_t scenario, const ScenarioFacts& facts, std::size_t begin) {
    const auto record = std::span(stored()).subspan(begin);
    rows_.push_back({scenario, record.size(), facts});
    stored_.put(record_footer(scenario, record));
}

void ResultBatch::hash() {
    std::vector<std::span<const std::byte>> records;
    records.reserve(rows_.size() - digests_.size());
    std::uint64_t end = stored_.size();
    for (std::size_t row = rows_.size(); row-- > digests_.size();) {
        end -= rows_[row].length + record_footer_bytes;
        records.push_back(std::span(stored()).subspan(end, rows_[row].length));
    }
    std::ranges::reverse(records);
    std::vector<Sha256> digests = digests_of_records(records);
    if (digests_.empty()) {
        digests_ = std::move(digests);
    } else {
        digests_.insert(digests_.end(), digests.begin(), digests.end());
    }
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
