#include <tws_runtime/defaults.h>
#include <tws_runtime/parameters.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <sstream>

namespace tws_runtime {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : ", ") + word;
  return line;
}

/// Levenshtein distance: the fewest letters to insert, drop or change.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

/// What to say of an unknown key: the nearest known one if it may be a slip of the pen, else all of them.
std::string suggestion(const std::string& key, const std::set<std::string>& known) {
  if (known.empty()) return "no keys are known here";
  const auto nearer = [&](const std::string& a, const std::string& b) {
    return editDistance(key, a) < editDistance(key, b);
  };
  const std::string nearest = *std::min_element(known.begin(), known.end(), nearer);
  if (2 * editDistance(key, nearest) <= std::max(key.size(), nearest.size())) return "did you mean '" + nearest + "'?";
  return "known keys: " + join({known.begin(), known.end()});
}

/// A long text, as of a file that is no YAML, by its beginning: the reason stays one line.
std::string shown(const YAML::Node& node) {
  constexpr std::size_t kMost = 40;
  if (node.IsScalar()) {
    const std::string text = node.Scalar().substr(0, node.Scalar().find('\n'));
    return text.size() <= kMost && text == node.Scalar() ? "'" + text + "'" : "'" + text.substr(0, kMost) + "…'";
  }
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "nothing";
}

template <class Number>
std::string rangeText(Number least, Number greatest) {
  std::ostringstream text;
  text.precision(10);
  text << "[" << least << ", " << greatest << "]";
  return text.str();
}

bool readNumber(const YAML::Node& node, double& value) {
  return node.IsScalar() && YAML::convert<double>::decode(node, value) && !std::isnan(value);
}

/// Whole numbers may be written 6, 6.0 or 1e6.
bool readInteger(const YAML::Node& node, long& value) {
  if (!node.IsScalar()) return false;
  if (YAML::convert<long>::decode(node, value)) return true;
  constexpr double kExact = 9007199254740992.0;  // 2^53
  double number = 0.0;
  if (!readNumber(node, number) || number != std::floor(number) || std::abs(number) > kExact) return false;
  value = static_cast<long>(number);
  return true;
}

/// Where it is, and why, in one line, whatever the file has been quoted with.
[[noreturn]] void complain(const std::string& where, const YAML::Mark& mark, const std::string& reason) {
  std::string line = where;
  if (!mark.is_null()) line += ":" + std::to_string(mark.line + 1) + ":" + std::to_string(mark.column + 1);
  line += ": " + reason;
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  throw ParameterError(line);
}

/// The text of a file or pipe.
std::string textOf(const std::string& path) {
  constexpr std::size_t kMostBytes = 16U << 20U;
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> bytes{};
  while (file && text.size() <= kMostBytes) {
    file.read(bytes.data(), bytes.size());
    text.append(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (text.size() > kMostBytes) throw ParameterError(path + ": is larger than 16 MB: is it a file of parameters?");
  if (!file.eof()) throw ParameterError(path + ": cannot be read");
  return text;
}

/// Refuses keys that stand twice in a map, and trees that are no trees: an alias (*name) stands for all that is under
/// its anchor (&name), so that a few of them may stand for more than any memory holds, or for themselves.
class TreeCheck {
 public:
  TreeCheck(std::string path, std::size_t bytes) : path_(std::move(path)), left_(kFewest + kMostPerByte * bytes) {}

  void check(const YAML::Node& node, int depth = 0) {
    if (depth == kDeepest) complain(path_, node.Mark(), "is nested deeper than 100 times");
    if (left_-- == 0) complain(path_, node.Mark(), "aliases (*name) stand for more than 10 times what is in the file");
    std::set<std::string> seen;
    for (const auto& entry : node) {
      if (node.IsMap() && entry.first.IsScalar() && !seen.insert(entry.first.Scalar()).second)
        complain(path_, entry.first.Mark(), "key '" + entry.first.Scalar() + "' stands twice in this map");
      check(node.IsMap() ? entry.second : YAML::Node(entry), depth + 1);
    }
  }

 private:
  static constexpr int kDeepest = 100;
  static constexpr std::size_t kFewest = 1000, kMostPerByte = 10;

  std::string path_;
  std::size_t left_;  // values that may still come
};

/// Where departuresFromDefaults() collects them; nowhere otherwise.
thread_local std::vector<std::string>* departures = nullptr;

bool same(double a, double b) { return a == b || std::abs(a - b) < 1e-12 * std::abs(a); }  // units were converted

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return same(x, y); });
}

template <class Value>
bool same(const Value& a, const Value& b) {
  return a == b;
}

/// Puts what was read into its variable.
template <class Value>
void take(Value& value, const Value& read, const std::string& path, const YAML::Node& node) {
  if (departures && path.find('[') == std::string::npos && !same(value, read))
    departures->push_back(path + ": " + shown(node) + " is not the default");
  value = read;
}

}  // namespace

std::vector<std::string> departuresFromDefaults(const std::function<void()>& reading) {
  std::vector<std::string> found;
  departures = &found;
  try {
    reading();
  } catch (...) {
    departures = nullptr;
    throw;
  }
  departures = nullptr;
  return found;
}

ParameterReader::ParameterReader(const YAML::Node& tree, std::string where)
    : ParameterReader(tree, std::move(where), "") {}

ParameterReader::ParameterReader(const YAML::Node& tree, std::string where, std::string path)
    : tree_(tree), where_(std::move(where)), path_(std::move(path)) {
  const bool empty = !tree_.IsDefined() || tree_.IsNull();
  if (!empty && !tree_.IsMap()) failAt(tree_, path_, "expected a map, found " + shown(tree_));
}

bool ParameterReader::has(const std::string& key) const {
  const YAML::Node& tree = tree_;
  return tree.IsDefined() && tree.IsMap() && tree[key].IsDefined();
}

std::vector<std::string> ParameterReader::keys() const {
  std::vector<std::string> keys;
  if (tree_.IsDefined() && tree_.IsMap())
    for (const auto& entry : tree_) keys.push_back(entry.first.Scalar());
  return keys;
}

void ParameterReader::number(const std::string& key, double& value, double least, double greatest) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  double read = 0.0;
  if (!readNumber(node, read)) failAt(node, pathTo(key), "expected a number, found " + shown(node));
  if (read < least || read > greatest)
    failAt(node, pathTo(key), node.Scalar() + " is not in " + rangeText(least, greatest));
  take(value, read, pathTo(key), node);
}

void ParameterReader::integer(const std::string& key, long& value, long least, long greatest) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  long read = 0;
  if (!readInteger(node, read)) failAt(node, pathTo(key), "expected a whole number, found " + shown(node));
  if (read < least || read > greatest)
    failAt(node, pathTo(key), node.Scalar() + " is not in " + rangeText(least, greatest));
  take(value, read, pathTo(key), node);
}

void ParameterReader::flag(const std::string& key, bool& value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  bool read = false;
  if (!node.IsScalar() || !YAML::convert<bool>::decode(node, read))
    failAt(node, pathTo(key), "expected true or false, found " + shown(node));
  take(value, read, pathTo(key), node);
}

void ParameterReader::text(const std::string& key, std::string& value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar()) failAt(node, pathTo(key), "expected text, found " + shown(node));
  take(value, node.Scalar(), pathTo(key), node);
}

void ParameterReader::choice(const std::string& key, std::string& value, const std::vector<std::string>& allowed) {
  std::string read = value;
  text(key, read);
  if (has(key) && std::find(allowed.begin(), allowed.end(), read) == allowed.end())
    fail(key, "'" + read + "' is not one of " + join(allowed));
  value = read;
}

void ParameterReader::numbers(const std::string& key, std::vector<double>& values, double least, double greatest) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence()) failAt(node, pathTo(key), "expected a list of numbers, found " + shown(node));
  std::vector<double> read(node.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::string path = pathTo(key) + "[" + std::to_string(i) + "]";
    if (!readNumber(node[i], read[i])) failAt(node[i], path, "expected a number, found " + shown(node[i]));
    if (read[i] < least || read[i] > greatest)
      failAt(node[i], path, node[i].Scalar() + " is not in " + rangeText(least, greatest));
  }
  take(values, read, pathTo(key), node);
}

void ParameterReader::texts(const std::string& key, std::vector<std::string>& values) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence()) failAt(node, pathTo(key), "expected a list of texts, found " + shown(node));
  std::vector<std::string> read;
  for (const YAML::Node& element : node) {
    if (!element.IsScalar()) failAt(element, pathTo(key), "expected text, found " + shown(element));
    read.push_back(element.Scalar());
  }
  take(values, read, pathTo(key), node);
}

void ParameterReader::require(const std::string& key) const {
  if (!has(key)) failAt(tree_, pathTo(key), "is required and missing");
}

ParameterReader ParameterReader::map(const std::string& key) { return {find(key), where_, pathTo(key)}; }

std::vector<ParameterReader> ParameterReader::list(const std::string& key) {
  const YAML::Node node = find(key);
  std::vector<ParameterReader> readers;
  if (!node.IsDefined()) return readers;
  if (!node.IsSequence()) failAt(node, pathTo(key), "expected a list of maps, found " + shown(node));
  for (std::size_t i = 0; i < node.size(); ++i)
    readers.push_back({node[i], where_, pathTo(key) + "[" + std::to_string(i) + "]"});
  return readers;
}

void ParameterReader::done() const {
  if (!tree_.IsDefined() || !tree_.IsMap()) return;
  for (const auto& entry : tree_) {
    const std::string key = entry.first.Scalar();
    if (known_.count(key) == 0) failAt(entry.first, pathTo(key), "is not a known key; " + suggestion(key, known_));
  }
}

void ParameterReader::fail(const std::string& key, const std::string& reason) const {
  const YAML::Node& tree = tree_;
  failAt(has(key) ? tree[key] : tree, pathTo(key), reason);
}

YAML::Node ParameterReader::find(const std::string& key) {
  known_.insert(key);
  const YAML::Node& tree = tree_;
  return has(key) ? tree[key] : YAML::Node(YAML::NodeType::Undefined);
}

void ParameterReader::failAt(const YAML::Node& node, const std::string& path, const std::string& reason) const {
  complain(where_, node.IsDefined() ? node.Mark() : YAML::Mark::null_mark(),
           (path.empty() ? "" : path + ": ") + reason);
}

std::string ParameterReader::pathTo(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

void scaledNumber(ParameterReader& reader, const std::string& key, double& value, double unit, double least,
                  double greatest) {
  if (!reader.has(key)) return reader.number(key, value, least, greatest);
  double read = value / unit;
  reader.number(key, read, least, greatest);
  value = read * unit;
}

YAML::Node parseParameters(const std::string& text, const std::string& name) try {
  const YAML::Node tree = YAML::Load(text);
  TreeCheck(name, text.size()).check(tree);
  return tree.IsNull() ? YAML::Node(YAML::NodeType::Map) : tree;
} catch (const YAML::Exception& error) {
  complain(name, error.mark, error.msg);
}

YAML::Node loadParameterFile(const std::string& path) { return parseParameters(textOf(path), path); }

YAML::Node withoutRuntimeKeys(const YAML::Node& tree) {
  if (!tree.IsDefined() || !tree.IsMap()) return tree;
  YAML::Node kept(YAML::NodeType::Map);
  for (const auto& entry : tree)
    if (entry.first.Scalar() != "live") kept[entry.first] = entry.second;
  return kept;
}

YAML::Node mergeParameters(const YAML::Node& base, const YAML::Node& overriding) {
  if (!overriding.IsDefined() || overriding.IsNull()) return base;
  if (!base.IsDefined() || !base.IsMap() || !overriding.IsMap()) return overriding;
  YAML::Node merged(YAML::NodeType::Map);
  for (const auto& entry : base) {
    const YAML::Node& other = overriding;
    const YAML::Node replacement = other[entry.first.Scalar()];
    merged[entry.first] = replacement.IsDefined() ? mergeParameters(entry.second, replacement) : entry.second;
  }
  for (const auto& entry : overriding)
    if (!base[entry.first.Scalar()].IsDefined()) merged[entry.first] = entry.second;
  return merged;
}

}  // namespace tws_runtime
