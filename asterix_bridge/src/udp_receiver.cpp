#include "udp_receiver.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <stdexcept>

namespace asterix_bridge {

namespace ip = boost::asio::ip;

class UdpReceiver::Impl {
 public:
  explicit Impl(const UdpAddress& address) : socket_(context_) {
    try {
      open(address);
    } catch (const boost::system::system_error& error) {
      throw std::runtime_error("UDP " + address.address + ":" + std::to_string(address.port) + ": " + error.what());
    }
  }

  void receive(const OnDatagram& on_datagram) {
    constexpr int kMost = 1000;  // then others have their turn
    for (int i = 0; i < kMost; ++i) {
      boost::system::error_code error;
      ip::udp::endpoint sender;
      const std::size_t size = socket_.receive_from(boost::asio::buffer(buffer_), sender, 0, error);
      if (error == boost::asio::error::would_block) return;
      if (error) throw std::runtime_error("UDP: " + error.message());
      on_datagram({buffer_.data(), size}, sender.address().to_string() + ":" + std::to_string(sender.port()));
    }
  }

 private:
  // A group is received on its own address, so that other groups on the same port stay out.
  void open(const UdpAddress& where) {
    const ip::address address = ip::make_address(where.address);
    const ip::udp::endpoint endpoint(address, where.port);
    socket_.open(endpoint.protocol());
    // Several may listen to a group; a port of this machine is one program's alone.
    if (address.is_multicast()) socket_.set_option(ip::udp::socket::reuse_address(true));
    boost::system::error_code ignored;  // The system may allow less: then it is less.
    socket_.set_option(boost::asio::socket_base::receive_buffer_size(4 << 20), ignored);
    socket_.bind(endpoint);
    socket_.non_blocking(true);
    if (!address.is_multicast()) return;
    const int joined_only = 0;  // else groups come that other programs joined on other interfaces
    if (address.is_v4()) setsockopt(socket_.native_handle(), IPPROTO_IP, IP_MULTICAST_ALL, &joined_only, sizeof(int));
    if (where.interface.empty())
      socket_.set_option(ip::multicast::join_group(address));
    else
      socket_.set_option(ip::multicast::join_group(address.to_v4(), ip::make_address_v4(where.interface)));
  }

  boost::asio::io_context context_;
  ip::udp::socket socket_;
  std::array<std::uint8_t, 65536> buffer_;
};

UdpReceiver::UdpReceiver(const UdpAddress& address) : impl_(std::make_unique<Impl>(address)) {}
UdpReceiver::~UdpReceiver() = default;
UdpReceiver::UdpReceiver(UdpReceiver&&) noexcept = default;
void UdpReceiver::receive(const OnDatagram& on_datagram) { impl_->receive(on_datagram); }

}  // namespace asterix_bridge
