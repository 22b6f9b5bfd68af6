#pragma once

#include <functional>
#include <memory>
#include <string>

#include "asterix_params.h"
#include "byte_reader.h"

namespace asterix_bridge {

/// Receives datagrams, unicast or multicast, without ever waiting.
class UdpReceiver {
 public:
  /// Throws std::runtime_error that names the address when it cannot be opened, or the group not be joined.
  explicit UdpReceiver(const UdpAddress& address);
  ~UdpReceiver();
  UdpReceiver(UdpReceiver&&) noexcept;

  using OnDatagram = std::function<void(Bytes datagram, const std::string& sender)>;
  /// Hands over what has come since the last call, at most 1000 datagrams. Throws std::runtime_error when the socket
  /// fails.
  void receive(const OnDatagram& on_datagram);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asterix_bridge
