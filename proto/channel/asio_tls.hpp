// The only header that includes Boost.Asio's TLS, and OpenSSL's with it.
#pragma once

#include "proto/channel/asio.hpp"

#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/error.hpp>
#include <boost/asio/ssl/stream.hpp>
