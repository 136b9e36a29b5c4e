#include "master/identity/token_book.hpp"

#include "common/core/limits/master.hpp"
#include "common/core/limits/wire.hpp"
#include "common/core/timing/master.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <sstream>

namespace cd {

namespace {

constexpr std::string_view first_line = "cdcluster tokens 2\n";
constexpr std::string_view sum_word = "sha256 ";

std::uint64_t random_id() {
    const Sha256 random = random_secret();
    std::uint64_t id = 0;
    std::memcpy(&id, random.bytes.data(), sizeof id);
    return id;
}

std::int64_t to_seconds(WallTime time) {
    return std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count();
}

/// Returns the last line of the text: the hash of all lines before it.
std::string sum_line(std::string_view lines) {
    return std::string(sum_word) + to_hex(sha256(std::as_bytes(std::span(lines)))) + '\n';
}

Error refused(const std::string& why) {
    return {ErrorCode::Refused, "the token " + why};
}

} // namespace

Result<JoinToken> TokenBook::create(const Terms& terms, const Sha256& authority, WallTime now) {
    if (terms.role == CertifiedRole::Master) {
        return Error{ErrorCode::BadInput, "no token makes a master"};
    }
    if (terms.uses == 0 || terms.uses > limits::token_uses_max || terms.until <= now ||
        terms.until > now + timing::token_life_max) {
        return Error{ErrorCode::BadInput,
                     "a token is good for 1 to " + std::to_string(limits::token_uses_max) +
                         " uses within " + std::to_string(timing::token_life_max.count() / 24) +
                         " days"};
    }
    std::erase_if(tokens_, [now](const auto& entry) { return entry.second.until <= now; });
    if (tokens_.size() >= limits::tokens_max) {
        return Error{ErrorCode::TooLarge,
                     std::to_string(tokens_.size()) + " tokens wait to be used or to expire"};
    }
    const JoinToken token{random_id(), random_secret(), authority};
    tokens_[token.id] = {stored_secret(token), terms.role, terms.uses, terms.until};
    return token;
}

Result<CertifiedRole> TokenBook::redeem(const Proof& proof, WallTime now) {
    const auto found = tokens_.find(proof.token);
    if (found == tokens_.end()) {
        return refused("is not known");
    }
    Entry& entry = found->second;
    // Checked first, so that the other errors reveal properties of the token only to its owner.
    if (!is_join_proof(proof.proof, entry.stored, proof.binding, proof.request)) {
        return refused("is not proven on this connection: wrong, or replayed");
    }
    if (entry.until <= now) {
        return refused("has expired");
    }
    if (entry.uses_left == 0) {
        return refused("is exhausted");
    }
    --entry.uses_left;
    return entry.role;
}

std::string TokenBook::to_text() const {
    std::ostringstream out;
    out << first_line;
    for (const auto& [id, entry] : tokens_) {
        out << id << ' ' << to_hex(entry.stored) << ' ' << cd::to_text(entry.role) << ' '
            << entry.uses_left << ' ' << to_seconds(entry.until) << '\n';
    }
    return out.str() + sum_line(out.str());
}

Result<TokenBook> TokenBook::parse(const std::string& text) {
    const std::size_t end = text.rfind(sum_word);
    if (end == std::string::npos || text.substr(end) != sum_line(text.substr(0, end))) {
        return Error{ErrorCode::BadInput, "a list of tokens that is damaged or cut short"};
    }
    if (!text.starts_with(first_line)) {
        return Error{ErrorCode::BadInput, "line 1 is not of a list of tokens"};
    }
    std::istringstream lines(text.substr(first_line.size(), end - first_line.size()));
    std::string line;
    TokenBook book;
    for (std::size_t number = 2; std::getline(lines, line); ++number) {
        std::istringstream fields(line);
        std::uint64_t id = 0;
        std::string stored;
        std::string role;
        Entry entry;
        std::int64_t seconds = 0;
        fields >> id >> stored >> role >> entry.uses_left >> seconds;
        const auto hash = sha256_from_hex(stored);
        const auto known_role = certified_role_from_text(role);
        const auto until = wall_time(seconds);
        if (fields.fail() || !fields.eof() || !hash || !known_role || !until) {
            return Error{ErrorCode::BadInput,
                         "line " + std::to_string(number) + " is not of a list of tokens"};
        }
        entry.stored = *hash;
        entry.role = *known_role;
        entry.until = *until;
        book.tokens_[id] = entry;
    }
    return book;
}

} // namespace cd
