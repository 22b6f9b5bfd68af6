#include "tws_core/output_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <streambuf>

namespace tws {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(path + ": " + what);
}

[[noreturn]] void failWith(const std::string& path, const char* what, int error) {
  fail(path, std::string(what) + ": " + std::strerror(error));
}

const char* const kNotWritten = "cannot be written";

fs::path folderOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// Opens a file that is new for sure, and sets its name.
int openNew(const std::string& path, std::string& part) {
  constexpr int kMostTrials = 1000;
  const std::string stem = folderOf(path) / (".tws-" + std::to_string(::getpid()) + "-");
  for (int trial = 0;; ++trial) {
    part = stem + std::to_string(trial) + ".part";
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file >= 0) return file;
    if (errno != EEXIST || trial == kMostTrials) failWith(path, kNotWritten, errno);
  }
}

/// Who could use the file before can use it afterwards.
void keepMode(int file, const std::string& path) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) == 0 && ::fchmod(file, there.st_mode & 0777U) != 0)
    failWith(path, kNotWritten, errno);
}

/// An open file that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  /// 0, or the error. Some file systems say only here that the disk is full.
  int close() {
    const int result = number_ >= 0 && ::close(number_) != 0 ? errno : 0;
    number_ = -1;
    return result;
  }

 private:
  int number_;
};

}  // namespace

void checkOutputPath(const std::string& path, const std::vector<std::string>& inputs) {
  if (path.empty() || fs::path(path).filename().empty()) fail("'" + path + "'", "is no name of a file");
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return;
  if (!S_ISREG(there.st_mode)) fail(path, "cannot be written: it exists and is no regular file");
  for (const std::string& input : inputs) {
    struct stat read {};
    if (::stat(input.c_str(), &read) == 0 && read.st_dev == there.st_dev && read.st_ino == there.st_ino)
      fail(path, "is the input itself; name another file");
  }
}

class OutputFile::Buffer : public std::streambuf {
 public:
  Buffer(int file, std::string path) : file_(file), path_(std::move(path)) { clear(); }

  /// Writes all that it holds.
  void flush() {
    const char* next = pbase();
    while (next < pptr()) {
      const ssize_t written = ::write(file_.number(), next, static_cast<std::size_t>(pptr() - next));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) failWith(path_, kNotWritten, errno);
      next += written;
    }
    clear();
  }

  int descriptor() const { return file_.number(); }
  int close() { return file_.close(); }

 private:
  void clear() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }
  int sync() override {
    flush();
    return 0;
  }
  int_type overflow(int_type byte) override {
    flush();
    if (traits_type::eq_int_type(byte, traits_type::eof())) return traits_type::not_eof(byte);
    return sputc(traits_type::to_char_type(byte));
  }

  Descriptor file_;
  std::string path_;
  std::array<char, 65536> bytes_{};
};

OutputFile::OutputFile(std::string path, const std::vector<std::string>& inputs)
    : path_(std::move(path)), stream_(nullptr) {
  checkOutputPath(path_, inputs);
  buffer_ = std::make_unique<Buffer>(openNew(path_, part_), path_);
  stream_.rdbuf(buffer_.get());
  stream_.exceptions(std::ios::badbit);  // So that what the buffer throws comes out.
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::discard() {
  if (!part_.empty()) ::unlink(part_.c_str());
  part_.clear();
}

void OutputFile::finish() {
  buffer_->flush();
  keepMode(buffer_->descriptor(), path_);
  if (const int error = buffer_->close(); error != 0) failWith(path_, kNotWritten, error);
  checkOutputPath(path_, {});
  if (::rename(part_.c_str(), path_.c_str()) != 0) failWith(path_, kNotWritten, errno);
  part_.clear();
}

std::string readRegularFile(const std::string& path, std::size_t most) {
  constexpr const char* kNotRead = "cannot be read";
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat there {};
  if (file.number() < 0 || ::fstat(file.number(), &there) != 0) failWith(path, kNotRead, errno);
  if (!S_ISREG(there.st_mode)) fail(path, "cannot be read: it is no regular file");
  std::string text;
  std::array<char, 65536> bytes{};
  while (text.size() <= most) {
    const ssize_t count = ::read(file.number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) failWith(path, kNotRead, errno);
    if (count == 0) return text;
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
  fail(path, "is larger than " + std::to_string(most) + " bytes");
}

std::uint64_t spaceFor(const std::string& path) {
  std::uint64_t space = std::numeric_limits<std::uint64_t>::max();
  struct statvfs disk {};
  if (::statvfs(path.c_str(), &disk) == 0 || ::statvfs(folderOf(path).c_str(), &disk) == 0)
    space = static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
  struct rlimit limit {};
  struct stat there {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return space;
  const std::uint64_t size = ::stat(path.c_str(), &there) == 0 ? static_cast<std::uint64_t>(there.st_size) : 0;
  return std::min<std::uint64_t>(space, limit.rlim_cur > size ? limit.rlim_cur - size : 0);
}

}  // namespace tws
