#include <track_evaluation/evaluation_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "evaluation", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<track_evaluation::EvaluationNode>(bus);
  });
}
