#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace fuzzing {

/// What a fuzz target is: it reads the input as programs do. Whatever is thrown out of it is a finding, and so is an
/// input that costs more time than its bytes are worth.
void fuzz(std::string_view input);

/// Inputs as a file in memory, for what reads from a path.
class InputFile {
 public:
  InputFile();
  const std::string& path() const { return path_; }
  void write(std::string_view input) const;

 private:
  int descriptor_;
  std::string path_;
};

/// The one of this program.
const InputFile& inputFile();

/// Ends the program, for libFuzzer to keep the input.
[[noreturn]] void found(const std::string& what);

/// Reads what may be wrong. A complaint must be a std::runtime_error in one line that begins with `name`.
template <class Read>
void readOrComplain(const std::string& name, Read read) {
  try {
    read();
  } catch (const std::runtime_error& error) {
    const std::string said = error.what();
    if (said.rfind(name, 0) != 0) found("the complaint does not name " + name + ": " + said);
    if (said.find('\n') != std::string::npos) found("the complaint has several lines: " + said);
  }
}

/// The same of what reads inputFile().
template <class Read>
void attempt(Read read) {
  readOrComplain(inputFile().path(), read);
}

}  // namespace fuzzing
