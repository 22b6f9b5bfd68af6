#include "launch_xml.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace tws_launch {
namespace {

/// XML takes a bare new line in an attribute for a space.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n' || c == '\t' || c == '\r')
      result += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      result += c;
  }
  return result;
}

std::string attribute(const std::string& name, const std::string& value) {
  return value.empty() ? "" : " " + name + "=\"" + escaped(value) + "\"";
}

/// A word of a command line, which roslaunch splits as a shell does.
std::string word(const std::string& text) {
  if (text.find("$(") != std::string::npos)
    throw std::runtime_error("'" + text + "': roslaunch would replace what begins with $( in it; choose another name");
  const bool plain = text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:,-") ==
                     std::string::npos;
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\"'\"'") : std::string(1, c);
  return quoted + "'";
}

std::string joinedArguments(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) line += (line.empty() ? "" : " ") + word(argument);
  return line;
}

void writeRemaps(std::ostream& out, const std::map<std::string, std::string>& remaps, const std::string& indent) {
  for (const auto& [from, to] : remaps)
    out << indent << "<remap" << attribute("from", from) << attribute("to", to) << "/>\n";
}

void writeParameters(std::ostream& out, const YAML::Node& parameters) {
  if (!parameters.IsMap() || parameters.size() == 0) return;
  out << "      <rosparam>\n";
  for (const auto& entry : parameters)
    out << inOneLine(entry.first) << ": " << escaped(inOneLine(entry.second)) << "\n";
  out << "      </rosparam>\n";
}

const char* const kManager = "manager";

/// A run ends with its source, and when a tracker or the recorder dies.
bool endsTheRun(const NodeDescription& node) { return node.role != "watcher" && !node.respawn; }

/// Our nodes are nodelets, too: NODE of the package is the class PACKAGE/NODElet.
bool isNodelet(const GraphDescription& graph, const NodeDescription& node) {
  const std::string ending = "_node";
  return graph.nodelets && node.type.size() > ending.size() &&
         node.type.compare(node.type.size() - ending.size(), ending.size(), ending) == 0;
}

void writeProgram(std::ostream& out, const NodeDescription& node) {
  out << "    <node" << attribute("pkg", node.package) << attribute("type", node.type) << attribute("name", node.name)
      << attribute("output", node.quiet ? "log" : "screen") << attribute("required", endsTheRun(node) ? "true" : "");
  if (node.respawn) out << " respawn=\"true\" respawn_delay=\"0.5\"";
  out << attribute("args", joinedArguments(node.arguments)) << attribute("launch-prefix", node.prefix) << ">\n";
}

/// The process that loads it; when the nodelet is to end the run, it ends the manager.
void writeNodelet(std::ostream& out, const NodeDescription& node) {
  out << "    <node pkg=\"nodelet\" type=\"nodelet\"" << attribute("name", node.name) << " output=\"screen\""
      << attribute("args", "load " + node.package + "/" + node.type + "let " + kManager) << ">\n";
  if (endsTheRun(node)) out << "      <param name=\"live/required\" value=\"true\"/>\n";
}

void writeNode(std::ostream& out, const GraphDescription& graph, const NodeDescription& node) {
  isNodelet(graph, node) ? writeNodelet(out, node) : writeProgram(out, node);
  writeRemaps(out, node.remaps, "      ");
  writeParameters(out, node.parameters);
  out << "    </node>\n";
}

}  // namespace

std::string launchXml(const GraphDescription& graph) {
  std::ostringstream out;
  out << "<!-- Written by tws_inspect: a graph that followed from its input. -->\n<launch>\n"
      << "  <param name=\"/use_sim_time\" value=\"true\"/>\n"
      << "  <group" << attribute("ns", graph.space.empty() ? "/" : graph.space) << ">\n";
  writeRemaps(out, graph.remaps, "    ");
  if (graph.nodelets)
    out << "    <node pkg=\"nodelet\" type=\"nodelet\" args=\"manager\" output=\"screen\" required=\"true\""
        << attribute("name", kManager) << "/>\n";
  for (const NodeDescription& node : graph.nodes) writeNode(out, graph, node);
  out << "  </group>\n</launch>\n";
  return out.str();
}

}  // namespace tws_launch
