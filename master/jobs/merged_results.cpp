#include "master/jobs/merged_results.hpp"

#include "common/core/check.hpp"
#include "common/core/limits/master.hpp"

#include <algorithm>

namespace cd {

MergedResults::PackedFacts MergedResults::pack(const ScenarioFacts& facts) {
    CD_CHECK(facts.pair_count <= limits::result_pairs_max);
    return {facts.pair_count,
            static_cast<std::uint64_t>(facts.kind),
            facts.surfaces_only,
            facts.insides_skipped,
            facts.is_cut,
            facts.has_distance};
}

ScenarioFacts MergedResults::facts_of(std::uint64_t scenario) const {
    const PackedFacts& facts = facts_.at(scenario);
    return {static_cast<ScenarioClass>(facts.kind),
            facts.surfaces_only != 0,
            facts.insides_skipped != 0,
            facts.is_cut != 0,
            facts.has_distance != 0,
            facts.pair_count,
            scenario < near_counts_.size() ? near_counts_[scenario] : 0};
}

void MergedResults::set_near_count(std::uint64_t scenario, std::uint64_t count) {
    if (scenario >= near_counts_.size()) {
        if (count == 0) {
            return; // Jobs without a clearance need no list.
        }
        near_counts_.resize(merger_.places());
    }
    near_counts_[scenario] = count;
}

std::uint32_t MergedResults::number_of(const std::shared_ptr<const Author>& author) {
    if (author == authors_[number_last_]) {
        return number_last_;
    }
    if (author == nullptr) {
        return 0;
    }
    const auto [number, is_new] =
        numbers_.try_emplace(author.get(), static_cast<std::uint32_t>(authors_.size()));
    if (is_new) {
        authors_.push_back(author);
    }
    number_last_ = number->second;
    return number_last_;
}

void MergedResults::restore(std::uint64_t scenario,
                            const ScenarioFacts& facts,
                            const std::shared_ptr<const Author>& author) {
    CD_CHECK(has(scenario));
    if (scenario >= facts_.size()) {
        facts_.resize(merger_.places());
        author_numbers_.resize(merger_.places());
    }
    facts_[scenario] = pack(facts);
    set_near_count(scenario, facts.near_count);
    author_numbers_[scenario] = number_of(author);
}

MergedResults::Outcome MergedResults::add(std::uint64_t scenario,
                                          const ScenarioFacts& facts,
                                          const Sha256& digest,
                                          const std::shared_ptr<const Author>& author) {
    const Outcome outcome = merger_.add(scenario, facts, digest);
    if (outcome == Outcome::Added) {
        restore(scenario, facts, author);
    }
    return outcome;
}

std::vector<std::uint64_t> MergedResults::withdraw(InstanceId process) {
    std::vector<std::uint64_t> withdrawn;
    for (std::uint64_t scenario = 0; scenario < author_numbers_.size(); ++scenario) {
        const auto& author = authors_[author_numbers_[scenario]];
        if (author != nullptr && author->process == process) {
            withdraw_one(scenario);
            withdrawn.push_back(scenario);
        }
    }
    return withdrawn;
}

void MergedResults::withdraw_one(std::uint64_t scenario) {
    merger_.remove(scenario, facts_of(scenario));
    author_numbers_[scenario] = 0;
}

std::shared_ptr<const Author> MergedResults::author_of(std::uint64_t scenario) const {
    return scenario < author_numbers_.size() ? authors_[author_numbers_[scenario]] : nullptr;
}

bool MergedResults::is_failed_by_master(std::uint64_t scenario) const {
    return has(scenario) && author_numbers_.at(scenario) == 0 &&
           facts_of(scenario).kind == ScenarioClass::Failed;
}

std::set<InstanceId> MergedResults::processes() const {
    std::vector<bool> counts(authors_.size());
    for (const std::uint32_t number : author_numbers_) {
        counts[number] = true;
    }
    std::set<InstanceId> processes = contributors_;
    for (std::size_t number = 1; number < authors_.size(); ++number) {
        if (counts[number]) {
            processes.insert(authors_[number]->process);
        }
    }
    return processes;
}

std::shared_ptr<const std::vector<bool>> MergedResults::marks() const {
    if (summary().merged() == 0) {
        return nullptr;
    }
    auto marks = std::make_shared<std::vector<bool>>(summary().total);
    for (std::uint64_t scenario = 0; scenario < marks->size(); ++scenario) {
        (*marks)[scenario] = has(scenario);
    }
    return marks;
}

void MergedResults::close() {
    contributors_ = processes();
    merger_.close();
    GrowingList<PackedFacts>().swap(facts_);
    GrowingList<std::uint64_t>().swap(near_counts_);
    author_numbers_.resize(std::min(author_numbers_.size(), limits::authors_kept_max));
    author_numbers_.shrink_to_fit();
    numbers_ = {};
}

} // namespace cd
