#include "xml_rpc_tree.h"

#include <tws_runtime/parameters.h>

#include <charconv>
#include <cmath>

namespace tws_runtime {
namespace {

/// The shortest text that reads back as the same number.
std::string exactText(double number) {
  if (std::isnan(number)) return ".nan";
  if (std::isinf(number)) return number > 0 ? ".inf" : "-.inf";
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

}  // namespace

YAML::Node treeFromXmlRpc(XmlRpc::XmlRpcValue value, const std::string& where) {
  using XmlRpc::XmlRpcValue;
  YAML::Node tree;
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value) ? "true" : "false");
    case XmlRpcValue::TypeInt:
      return YAML::Node(std::to_string(static_cast<int>(value)));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(exactText(static_cast<double>(value)));
    case XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(value));
    case XmlRpcValue::TypeArray:
      tree = YAML::Node(YAML::NodeType::Sequence);
      for (int i = 0; i < value.size(); ++i) tree.push_back(treeFromXmlRpc(value[i], where));
      return tree;
    case XmlRpcValue::TypeStruct:
      tree = YAML::Node(YAML::NodeType::Map);
      for (auto& [key, member] : value) tree[key] = treeFromXmlRpc(member, std::string(where).append("/").append(key));
      return tree;
    case XmlRpcValue::TypeInvalid:
      return tree;
    default:
      throw ParameterError(where + ": is a date or binary data, which no parameter is");
  }
}

}  // namespace tws_runtime
