#include <esa_frame_builder/frame_builder_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "frame_builder", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<esa_frame_builder::FrameBuilderNode>(bus);
  });
}
