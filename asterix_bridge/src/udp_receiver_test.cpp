#include "udp_receiver.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <chrono>
#include <thread>

namespace asterix_bridge {
namespace {

using Udp = boost::asio::ip::udp;

/// A port that nobody uses now.
std::uint16_t freePort() {
  boost::asio::io_context context;
  return Udp::socket(context, Udp::endpoint(Udp::v4(), 0)).local_endpoint().port();
}

void send(const std::string& address, std::uint16_t port, const std::string& text) {
  boost::asio::io_context context;
  Udp::socket socket(context, Udp::v4());
  socket.set_option(boost::asio::ip::multicast::outbound_interface(boost::asio::ip::address_v4::loopback()));
  socket.set_option(boost::asio::ip::multicast::enable_loopback(true));
  socket.send_to(boost::asio::buffer(text), Udp::endpoint(boost::asio::ip::make_address(address), port));
}

/// What comes within a few seconds, up to so many datagrams.
std::vector<std::string> receive(UdpReceiver& receiver, std::size_t count) {
  std::vector<std::string> texts;
  for (int i = 0; i < 300 && texts.size() < count; ++i) {
    receiver.receive([&](Bytes bytes, const std::string& sender) {
      texts.emplace_back(bytes.data, bytes.data + bytes.size);
      EXPECT_EQ(sender.find("127.0.0.1:"), 0u) << sender;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return texts;
}

// Two programs on one port would share a radar's datagrams by chance, each without knowing of the other.
TEST(UdpReceiver, HasAPortOfThisMachineForItself) {
  const std::uint16_t port = freePort();
  const UdpReceiver first({"127.0.0.1", port, ""});
  EXPECT_THROW(UdpReceiver({"127.0.0.1", port, ""}), std::runtime_error);
  const UdpReceiver group({"239.1.2.3", port, "127.0.0.1"});
  EXPECT_NO_THROW(UdpReceiver({"239.1.2.3", port, "127.0.0.1"}));
}

TEST(UdpReceiver, GivesUnicastDatagramsInOrder) {
  const std::uint16_t port = freePort();
  UdpReceiver receiver({"127.0.0.1", port, ""});
  send("127.0.0.1", port, "one");
  send("127.0.0.1", port, "two");
  EXPECT_EQ(receive(receiver, 2), (std::vector<std::string>{"one", "two"}));
}

TEST(UdpReceiver, JoinsAMulticastGroup) {
  const std::uint16_t port = freePort();
  UdpReceiver receiver({"239.255.17.3", port, "127.0.0.1"});
  send("239.255.17.3", port, "to all");
  EXPECT_EQ(receive(receiver, 1), std::vector<std::string>{"to all"});
}

TEST(UdpReceiver, DoesNotWait) {
  UdpReceiver receiver({"127.0.0.1", freePort(), ""});
  receiver.receive([](Bytes, const std::string&) { FAIL() << "nothing was sent"; });
}

TEST(UdpReceiver, RefusesAnAddressThatIsNotOfThisMachine) {
  EXPECT_THROW(UdpReceiver({"192.0.2.1", 8600, ""}), std::runtime_error);
  EXPECT_THROW(UdpReceiver({"radar", 8600, ""}), std::runtime_error);
}

}  // namespace
}  // namespace asterix_bridge
