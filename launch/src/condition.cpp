#include "condition.h"

#include <sstream>
#include <stdexcept>

namespace tws_launch {
namespace {

/// Reads: terms joined by "and", groups of them joined by "or".
class ConditionReader {
 public:
  ConditionReader(const std::string& text, const std::function<bool(const std::string&)>& is)
      : text_(text), words_(text), is_(is) {
    words_ >> next_;
  }

  bool any() {
    bool holds = all();
    while (take("or")) holds = all() || holds;
    if (!next_.empty()) fail();
    return holds;
  }

 private:
  bool all() {
    bool holds = term();
    while (take("and")) holds = term() && holds;
    return holds;
  }

  bool term() {
    if (take("not")) return !term();
    if (next_.empty() || next_ == "and" || next_ == "or") fail();
    const std::string word = next_;
    take(word);
    return is_(word);
  }

  /// Goes on to the next word if this one is `word`.
  bool take(const std::string& word) {
    if (next_ != word) return false;
    next_.clear();
    words_ >> next_;
    return true;
  }

  [[noreturn]] void fail() const { throw std::invalid_argument("'" + text_ + "' is no condition"); }

  const std::string& text_;
  std::istringstream words_;
  std::string next_;
  const std::function<bool(const std::string&)>& is_;
};

}  // namespace

bool holds(const std::string& condition, const std::function<bool(const std::string&)>& is) {
  return condition.empty() || ConditionReader(condition, is).any();
}

}  // namespace tws_launch
