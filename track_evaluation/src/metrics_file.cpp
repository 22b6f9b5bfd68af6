#include "metrics_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace track_evaluation {
namespace {

std::string quoted(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) {
    char code[8] = {c, 0};
    if (static_cast<unsigned char>(c) < 0x20) std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
    if (c == '"' || c == '\\') word += '\\';
    word += code;
  }
  return word + "\"";
}

std::string exact(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string object(const MetricList& metrics, const std::string& indent) {
  std::string text = "{";
  for (const auto& [name, value] : metrics)
    text += (text.size() > 1 ? ",\n" : "\n") + indent + "  " + quoted(name) + ": " + exact(value);
  return text + (metrics.empty() ? "}" : "\n" + indent + "}");
}

std::string requirementObject(const RequirementRow& row) {
  return "{\"profile\": " + quoted(row.profile) + ", \"name\": " + quoted(row.name) +
         ", \"unit\": " + quoted(row.unit) + ", \"value\": " + exact(row.value) + ", \"limit\": " + exact(row.limit) +
         ", \"sense\": " + (row.at_least ? "\"at least\"" : "\"at most\"") +
         ", \"passed\": " + (row.known() ? row.passed() ? "true" : "false" : "null") + "}";
}

std::string requirementList(const std::vector<RequirementRow>& rows) {
  std::string text = "[";
  for (const RequirementRow& row : rows)
    text += (text.size() > 1 ? ",\n        " : "\n        ") + requirementObject(row);
  return text + (rows.empty() ? "]" : "\n      ]");
}

using Part = MetricList TrackerScore::*;

double valueOf(const MetricList& metrics, const std::string& name) {
  const auto found = std::find_if(metrics.begin(), metrics.end(), [&](const auto& m) { return m.first == name; });
  return found == metrics.end() ? std::nan("") : found->second;
}

/// Every name that some tracker has, in the order of the first that has it.
std::vector<std::string> namesOf(const RunScore& score, Part part) {
  std::vector<std::string> names;
  for (const TrackerScore& tracker : score.trackers)
    for (const auto& [name, value] : tracker.*part)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

constexpr int kName = 28, kColumn = 12;

void writePart(std::ostream& out, const RunScore& score, Part part) {
  for (const std::string& name : namesOf(score, part)) {
    out << std::left << std::setw(kName) << name << std::right;
    for (const TrackerScore& tracker : score.trackers)
      out << std::setw(kColumn) << inShort(valueOf(tracker.*part, name));
    out << '\n';
  }
}

}  // namespace

std::string inShort(double value) {
  if (std::isnan(value)) return "-";
  char text[40];
  const double size = std::abs(value);
  const bool whole = value == std::round(value) && size < 1e7;
  std::snprintf(text, sizeof text, whole || size >= 1000.0 ? "%.0f" : size >= 10.0 ? "%.1f" : "%.4g", value);
  return text;
}

void writeJson(std::ostream& out, const RunScore& score) {
  out << "{\n  \"version\": 1,\n  \"input\": " << quoted(score.input)
      << ",\n  \"settings\": " << object(score.settings, "  ") << ",\n  \"trackers\": {";
  const char* separator = "\n    ";
  for (const TrackerScore& tracker : score.trackers) {
    out << separator << quoted(tracker.tracker) << ": {\n      \"metrics\": " << object(tracker.metrics, "      ")
        << ",\n      \"identity\": " << object(tracker.identity, "      ")
        << ",\n      \"timing\": " << object(tracker.timing, "      ");
    if (!tracker.correlation.empty()) out << ",\n      \"correlation\": " << object(tracker.correlation, "      ");
    out << ",\n      \"requirements\": " << requirementList(tracker.requirements) << "\n    }";
    separator = ",\n    ";
  }
  out << (score.trackers.empty() ? "}" : "\n  }") << "\n}\n";
}

void writeTable(std::ostream& out, const RunScore& score) {
  out << std::left << std::setw(kName) << "evaluation" << std::right;
  for (const TrackerScore& tracker : score.trackers) out << std::setw(kColumn) << tracker.tracker;
  out << '\n';
  for (const Part part :
       {&TrackerScore::metrics, &TrackerScore::identity, &TrackerScore::correlation, &TrackerScore::timing})
    writePart(out, score, part);
  for (const TrackerScore& tracker : score.trackers) {
    for (const RequirementRow& row : tracker.requirements) {
      out << std::left << std::setw(kName) << (tracker.tracker + ": " + row.profile) << ' ' << std::setw(22) << row.name
          << std::right << std::setw(9) << inShort(row.value) << (row.at_least ? "  >= " : "  <= ") << std::left
          << std::setw(8) << inShort(row.limit) << (row.known() ? row.passed() ? "pass" : "FAIL" : "-") << '\n';
    }
  }
}

}  // namespace track_evaluation
