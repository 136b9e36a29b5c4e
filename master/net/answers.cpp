#include "master/net/answers.hpp"

#include "proto/codec/codec.hpp"

#include <string>
#include <utility>

namespace cd {

Message fitting(Message answer) {
    const std::uint16_t type = message_type(answer);
    const std::uint64_t bytes_max = payload_bytes_max(type);
    std::uint64_t bytes = encode_message(answer).size();
    if (auto* const status = std::get_if<ClusterStatus>(&answer)) {
        while (bytes > bytes_max && !status->meshes.empty()) {
            status->meshes.resize(status->meshes.size() / 2);
            bytes = encode_message(answer).size();
        }
    }
    if (bytes <= bytes_max) {
        return answer;
    }
    return Failure{ErrorCode::TooLarge,
                   "the answer, '" + std::string(message_name(type)) + "', takes " +
                       std::to_string(bytes) + " bytes, and a message " +
                       std::to_string(bytes_max) + " at most"};
}

} // namespace cd
