#include "launch_xml.h"

#include <algorithm>
#include <sstream>

namespace tws_launch {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string attribute(const std::string& name, const std::string& value) {
  return value.empty() ? "" : " " + name + "=\"" + escaped(value) + "\"";
}

/// A word of a command line, which roslaunch splits as a shell does. "$(" would be a substitution of roslaunch's.
std::string word(const std::string& text) {
  const bool plain = text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:,-") ==
                     std::string::npos;
  return plain ? text : "'" + text + "'";
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

void writeNode(std::ostream& out, const NodeDescription& node) {
  const bool ends_the_run = (node.role == "source" || node.role == "tracker") && !node.respawn;
  out << "    <node" << attribute("pkg", node.package) << attribute("type", node.type) << attribute("name", node.name)
      << attribute("output", node.quiet ? "log" : "screen") << attribute("required", ends_the_run ? "true" : "");
  if (node.respawn) out << " respawn=\"true\" respawn_delay=\"0.5\"";
  out << attribute("args", joinedArguments(node.arguments)) << attribute("launch-prefix", node.prefix) << ">\n";
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
  for (const NodeDescription& node : graph.nodes) writeNode(out, node);
  out << "  </group>\n</launch>\n";
  return out.str();
}

}  // namespace tws_launch
