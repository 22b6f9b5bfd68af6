#include <esa_frame_builder/mfa_stub_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "mfa_stub", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<esa_frame_builder::MfaStubNode>(bus);
  });
}
