#include "loopback_only.h"

#include <netinet/in.h>
#include <ros/network.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace tws_runtime {
namespace {

bool isOfThisMachineAlone(const std::string& host) { return host == "localhost" || host.rfind("127.", 0) == 0; }

bool listensAt(int file, std::uint32_t port) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  int listens = 0;
  if (::getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) != 0 || address.sin_family != AF_INET)
    return false;
  size = sizeof listens;
  return ntohs(address.sin_port) == port && ::getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) == 0 &&
         listens != 0;
}

}  // namespace

void keepOnLoopback() {
  if (!isOfThisMachineAlone(ros::network::getHost())) return;
  const std::uint32_t port = ros::XMLRPCManager::instance()->getServerPort();
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const int file = std::atoi(entry.path().filename().c_str());
    if (listensAt(file, port)) ::setsockopt(file, SOL_SOCKET, SO_BINDTODEVICE, "lo", sizeof "lo");
  }
}

}  // namespace tws_runtime
