#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

namespace tws {

/// A file that stands under its name only when it is whole: it is written beside it, under a name that was free, and
/// renamed by finish(). What stood there before stays until then, and for good when something fails.
class OutputFile {
 public:
  /// `path`: of a new file or of a regular one, in a folder that exists; it is none of `inputs`, whatever their names.
  /// Links, devices and pipes are refused. Throws std::runtime_error that names path and reason, as all here.
  explicit OutputFile(std::string path, const std::vector<std::string>& inputs = {});
  /// Removes what was not finished.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Throws at the first byte that cannot be written, and is not to be used after finish().
  std::ostream& stream() { return stream_; }
  /// Writes what is left, checks it and gives the file its name.
  void finish();

 private:
  class Buffer;
  void discard();

  std::string path_, part_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// Throws when an OutputFile could not be `path`. For programs that write a file in another way.
void checkOutputPath(const std::string& path, const std::vector<std::string>& inputs = {});

/// The text of a regular file of at most `most` bytes. Never waits for a device or a pipe. Throws std::runtime_error
/// that names the file and the reason.
std::string readRegularFile(const std::string& path, std::size_t most);

/// How much more can be written to a file [bytes]: what is free where it stands or will stand, and what the limit of
/// this process leaves. The greatest number there is where nobody knows.
std::uint64_t spaceFor(const std::string& path);

}  // namespace tws
