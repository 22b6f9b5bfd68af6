#include "graph_description.h"

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace tws_launch {
namespace {

/// A word for the shell that stands for exactly `text`.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// What a command prints. Throws std::runtime_error when it fails.
std::string outputOf(const std::string& command) {
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start " + command);
  std::string output;
  std::array<char, 4096> piece;
  while (const std::size_t length = std::fread(piece.data(), 1, piece.size(), pipe))
    output.append(piece.data(), length);
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return output;
}

}  // namespace

std::vector<NodeDescription> parseGraph(const std::string& yaml) {
  std::vector<NodeDescription> nodes;
  for (const YAML::Node& entry : YAML::Load(yaml))
    nodes.push_back({entry["package"].as<std::string>(), entry["type"].as<std::string>(),
                     entry["name"].as<std::string>(), entry["remaps"].as<std::map<std::string, std::string>>(),
                     entry["parameters"]});
  return nodes;
}

std::vector<NodeDescription> describeGraph(const std::string& launch_file, const std::vector<std::string>& arguments) {
  std::string command = "rosrun tws_launch describe_graph \"$(rospack find tws_launch)\"/" + quoted(launch_file);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  return parseGraph(outputOf(command));
}

}  // namespace tws_launch
