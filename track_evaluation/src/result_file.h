#pragma once

#include <tws_core/output_file.h>

#include <optional>
#include <string>
#include <vector>

namespace track_evaluation {

/// A file of results that may have been asked for.
class ResultFile {
 public:
  /// `path`: empty: nobody asked. Throws as tws::OutputFile.
  ResultFile(const std::string& path, const std::vector<std::string>& inputs) {
    if (!path.empty()) file_.emplace(path, inputs);
  }
  explicit operator bool() const { return file_.has_value(); }
  std::ostream& stream() { return file_->stream(); }
  void finish() {
    if (file_) file_->finish();
  }

 private:
  std::optional<tws::OutputFile> file_;
};

}  // namespace track_evaluation
