#include "client/local/done_block.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"

#include <utility>

namespace cd {

std::uint64_t DoneBlock::bytes() const {
    return records_.size() + size() * (sizeof(ScenarioFacts) + sizeof(Sha256)) + found_bytes_;
}

void DoneBlock::add(const ScenarioResult& result) {
    first_ = empty() ? result.index : first_;
    CD_CHECK(result.index == first_ + size());
    const std::size_t begin = records_.size() + sizeof(std::uint32_t);
    put_record(records_, result);
    facts_.push_back(facts_of(result));
    digests_.push_back(digest_of_record(std::span(records_.bytes()).subspan(begin)));
}

void DoneBlock::add(const ScenarioResult& result, std::vector<ContactPair> found) {
    add(result);
    found_bytes_ += sizeof found + found.size() * sizeof(ContactPair);
    found_.push_back(std::move(found));
    CD_CHECK(found_.size() == size());
}

Status DoneBlock::for_each(const std::function<Status(const DoneScenario&)>& take) const {
    ByteReader in(records_.bytes());
    for (std::size_t i = 0; i < size(); ++i) {
        const auto record = in.get_bytes(in.get<std::uint32_t>());
        auto result = decode_result(record);
        CD_CHECK(result.has_value());
        DoneScenario done{
            std::move(result.value()), Bytes(record.begin(), record.end()), digests_[i], {}};
        if (!found_.empty()) {
            done.found = found_[i];
        }
        CD_TRY(take(done));
    }
    return Done{};
}

DoneBlock block_of(const DoneScenario& done) {
    DoneBlock block;
    block.add(done.result, done.found);
    return block;
}

} // namespace cd
