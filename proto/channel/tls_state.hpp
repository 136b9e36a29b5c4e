// The contexts of a Tls. Only tls.cpp and stream.cpp include this.
#pragma once

#include "proto/channel/asio_tls.hpp"
#include "proto/channel/tls.hpp"

namespace cd {

struct Tls::State {
    asio::ssl::context accepting{asio::ssl::context::tls_server};
    asio::ssl::context connecting{asio::ssl::context::tls_client};
    std::optional<Identity> identity;
    Sha256 pinned; ///< Fingerprint of the authority, while joining.
};

} // namespace cd
