#include "fuzzing.h"

#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace fuzzing {
namespace {

// Work per byte is bounded: with sanitizers, ten times what the slowest reader takes for a long input.
constexpr double kMostSeconds = 0.5, kMostSecondsPerByte = 100e-6;

double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// How long to go on, of the processor's time [s].
double limit() {
  const char* seconds = std::getenv("FUZZING_SECONDS");
  return seconds == nullptr ? 5.0 : std::strtod(seconds, nullptr);
}

}  // namespace

InputFile::InputFile() : descriptor_(memfd_create("input", 0)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {
  if (descriptor_ < 0) found("no file in memory can be made");
}

void InputFile::write(std::string_view input) const {
  if (ftruncate(descriptor_, 0) != 0 ||
      pwrite(descriptor_, input.data(), input.size(), 0) != static_cast<ssize_t>(input.size()))
    found("the file in memory cannot be written");
}

const InputFile& inputFile() {
  static const InputFile kFile;
  return kFile;
}

void found(const std::string& what) {
  std::fprintf(stderr, "fuzzing: %s\n", what.c_str());
  std::abort();
}

}  // namespace fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const double kEnd = fuzzing::limit();
  const double start = fuzzing::processorSeconds();
  fuzzing::fuzz({reinterpret_cast<const char*>(data), size});
  const double end = fuzzing::processorSeconds();
  if (end - start > fuzzing::kMostSeconds + fuzzing::kMostSecondsPerByte * static_cast<double>(size))
    fuzzing::found(std::to_string(size) + " bytes take " + std::to_string(end - start) + " s");
  if (end > kEnd) std::raise(SIGUSR1);  // libFuzzer ends well after this input.
  return 0;
}
