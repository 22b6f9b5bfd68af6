#include "tws_core/output_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tws_core/file_size_limit_test_helpers.h"
#include "tws_core/temporary_folder_test_helpers.h"

namespace tws {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone afterwards.
class OutputFileTest : public testing::Test {
 protected:
  static void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string textOf(const std::string& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  /// What `OutputFile(path, inputs)` complains of.
  static std::string complaint(const std::string& path, const std::vector<std::string>& inputs = {}) {
    try {
      const OutputFile file(path, inputs);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

// If this fails, half a file stands where a whole one stood.
TEST_F(OutputFileTest, AFileHasItsNameOnlyWhenItIsWhole) {
  put(path("a"), "old");
  {
    OutputFile file(path("a"));
    file.stream() << "half" << std::flush;
    EXPECT_EQ(textOf(path("a")), "old");
  }
  EXPECT_EQ(textOf(path("a")), "old");
  EXPECT_EQ(files(), 1U);
  OutputFile file(path("a"));
  file.stream() << std::string(200000, 'x') << 12.5 << '\n';
  file.finish();
  EXPECT_EQ(textOf(path("a")), std::string(200000, 'x') + "12.5\n");
  EXPECT_EQ(files(), 1U);
}

// If this fails, a program on a full disk ends well with half of its results.
TEST_F(OutputFileTest, ADiskThatIsFullIsSaidAndTheOldFileStays) {
  put(path("a"), "old");
  const FileSizeLimit limit(100000);
  OutputFile file(path("a"));
  const auto write = [&] {
    for (int i = 0; i < 20; ++i) file.stream() << std::string(10000, 'x');
  };
  try {
    write();
    FAIL() << "nobody noticed";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), path("a") + ": cannot be written: File too large");
  }
  EXPECT_EQ(textOf(path("a")), "old");
}

TEST_F(OutputFileTest, ALastPieceThatDoesNotFitIsSaidAtTheEnd) {
  const FileSizeLimit limit(10);
  OutputFile file(path("a"));
  file.stream() << "more than ten bytes";
  EXPECT_THROW(file.finish(), std::runtime_error);
  EXPECT_FALSE(fs::exists(path("a")));
}

// If this fails, a slip of the pen destroys a recording.
TEST_F(OutputFileTest, TheInputIsNeverTheOutput) {
  put(path("in"), "data");
  fs::create_hard_link(path("in"), path("same"));
  for (const char* name : {"in", "./in", "same"}) {
    const std::string output = path(name);
    EXPECT_EQ(complaint(output, {path("in")}), output + ": is the input itself; name another file");
  }
  EXPECT_EQ(complaint(path("in"), {path("other")}), "");
  EXPECT_EQ(textOf(path("in")), "data");
}

// If this fails, root replaces a device by a file of numbers, or a link leads the output out of its folder.
TEST_F(OutputFileTest, LinksDevicesPipesAndFoldersAreRefused) {
  put(path("secret"), "secret");
  fs::create_symlink(path("secret"), path("link"));
  fs::create_symlink(path("nowhere"), path("dangling"));
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::string& name : {path("link"), path("dangling"), path("pipe"), std::string("/dev/null"), path("")})
    EXPECT_NE(complaint(name), "") << name;
  EXPECT_EQ(complaint(path("link")), path("link") + ": cannot be written: it exists and is no regular file");
  EXPECT_EQ(complaint(path("no/folder")), path("no/folder") + ": cannot be written: No such file or directory");
  EXPECT_EQ(textOf(path("secret")), "secret");
  EXPECT_FALSE(fs::exists(path("nowhere")));
}

// If this fails, who knows the next temporary name has the output written elsewhere.
TEST_F(OutputFileTest, ATemporaryNameThatIsTakenIsNotFollowed) {
  put(path("secret"), "secret");
  fs::create_symlink(path("secret"), folder_ / (".tws-" + std::to_string(::getpid()) + "-0.part"));
  OutputFile file(path("a"));
  file.stream() << "new";
  file.finish();
  EXPECT_EQ(textOf(path("secret")), "secret");
  EXPECT_EQ(textOf(path("a")), "new");
}

TEST_F(OutputFileTest, TheFilesModeStays) {
  put(path("a"), "old");
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  OutputFile file(path("a"));
  file.finish();
  struct stat there {};
  ASSERT_EQ(::stat(path("a").c_str(), &there), 0);
  EXPECT_EQ(there.st_mode & 0777U, 0640U);
}

// If this fails, /dev/zero or a pipe holds up a program for good.
TEST(ReadRegularFile, NothingElseIsReadAndNothingWithoutEnd) {
  const std::string path = testing::TempDir() + "read_regular_file_" + std::to_string(::getpid());
  const auto complaint = [&](const std::string& file, std::size_t most) {
    try {
      return readRegularFile(file, most);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  std::ofstream(path) << "12345";
  EXPECT_EQ(readRegularFile(path, 5), "12345");
  EXPECT_EQ(complaint(path, 4), path + ": is larger than 4 bytes");
  EXPECT_EQ(complaint("/dev/zero", 1000), "/dev/zero: cannot be read: it is no regular file");
  EXPECT_EQ(complaint(path + "x", 1), path + "x: cannot be read: No such file or directory");
  fs::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(complaint(path, 1000), path + ": cannot be read: it is no regular file");
  fs::remove(path);
}

TEST(SpaceFor, WhatIsFreeAndWhatTheLimitLeaves) {
  const std::string path = testing::TempDir() + "space_for_" + std::to_string(::getpid());
  EXPECT_GT(spaceFor(path), 1000000U);
  const FileSizeLimit limit(1000);
  EXPECT_EQ(spaceFor(path), 1000U);
  std::ofstream(path) << "12345";
  EXPECT_EQ(spaceFor(path), 995U);
  fs::remove(path);
}

}  // namespace
}  // namespace tws
