// The plots of an ASTERIX recording as CSV, without ROS. See README.md.
#include <CLI/CLI.hpp>
#include <iostream>

#include "radar_periods.h"
#include "recording.h"
#include "report_csv.h"

namespace asterix_bridge {
namespace {

constexpr int kMostComplaints = 10;

void complain(const Recording& recording, FaultKind kind, const BlockFault& fault, int count) {
  if (count > kMostComplaints) return;
  std::cerr << recording.path() << ": byte " << fault.offset << ": " << toText(kind) << ": " << fault.reason << '\n';
  if (count == kMostComplaints) std::cerr << recording.path() << ": further faults are only counted\n";
}

void convert(const std::string& path, bool records) {
  const Recording recording(path);
  const DataClock clock = clockFor(recording, std::nullopt);
  std::optional<PlotCsv> plots;
  std::optional<RecordCsv> all;
  records ? void(all.emplace(std::cout)) : void(plots.emplace(std::cout, periodsOf(recording, clock)));
  int faults = 0;
  RecordStream::Events events;
  events.report = [&](const TargetReport& report, double time) {
    plots ? plots->add(report, time) : all->add(report, time);
  };
  events.message = [&](const ServiceMessage& message, double time) {
    if (all) all->add(message, time);
  };
  events.fault = [&](FaultKind kind, const BlockFault& fault) { complain(recording, kind, fault, ++faults); };
  RecordStream stream(clock, std::move(events));
  const std::unique_ptr<BlockFinder> blocks = recording.blocks();
  while (const auto step = blocks->next()) stream.add(*step);
  stream.finish();
  std::cout.flush();
  if (!std::cout) throw std::runtime_error("writing failed");
  std::cerr << path << " (" << toText(recording.framing()) << "): " << stream.blocks() << " blocks, "
            << stream.records() << " records, " << faults << " faults"
            << (plots ? ", " + std::to_string(plots->leftOut()) + " reports without detection, position or time" : "")
            << '\n';
  if (stream.records() == 0) throw std::runtime_error(path + ": " + whyEmpty(contentsOf(recording, clock)));
  if (plots && plots->count() == 0)
    throw std::runtime_error(path + ": no plot came out of " + std::to_string(stream.records()) +
                             " records; --records shows them");
}

}  // namespace
}  // namespace asterix_bridge

int main(int argc, char** argv) {
  CLI::App app{"Prints the plots of an ASTERIX recording (CAT001, 002, 034, 048) as CSV."};
  std::string path;
  bool records = false;
  app.add_option("file", path, "recording: raw, pcap, pcapng, or with a recorder's framing")->required();
  app.add_flag("--records", records, "every record with all its fields, service messages too");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    asterix_bridge::convert(path, records);
  } catch (const std::exception& error) {
    std::cerr << "asterix_csv: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
