#include "command_words.h"

#include <algorithm>

namespace tws_launch {
namespace {

std::string withUnderscores(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

bool isFlag(const std::string& name) {
  const auto& all = runOptions();
  return std::any_of(all.begin(), all.end(), [&](const RunOption& option) {
    return option.name == name && option.type == RunOption::Type::kFlag;
  });
}

class WordReader {
 public:
  WordReader(const std::vector<std::string>& words, const std::set<std::string>& allowed,
             const std::set<std::string>& others)
      : words_(words), allowed_(allowed), others_(others) {}

  CommandWords read(std::size_t arguments) {
    while (next_ < words_.size()) take(words_[next_++]);
    if (result_.arguments.size() > arguments) throw UsageError("too many arguments");
    return result_;
  }

 private:
  void take(const std::string& word) {
    const std::size_t assigned = word.find(":=");
    if (assigned != std::string::npos && word[0] != '-')
      set(word.substr(0, assigned), word.substr(assigned + 2));
    else if (word.size() > 1 && word[0] == '-')
      takeOption(word);
    else
      result_.arguments.push_back(word);
  }

  void takeOption(const std::string& word) {
    if (word.rfind("--no-", 0) == 0 && isFlag(withUnderscores(word.substr(5)))) return set(word.substr(5), "false");
    const std::string name = word.rfind("--", 0) == 0 ? word.substr(2) : word;
    if (!isKnown(name)) throw UsageError("unknown option " + word);
    if (isFlag(withUnderscores(name))) return set(name, "true");
    if (next_ == words_.size()) throw UsageError(word + " wants a value");
    set(name, words_[next_++]);
  }

  bool isKnown(const std::string& name) const {
    const std::string key = withUnderscores(name);
    const auto& all = runOptions();
    const bool is_option = std::any_of(all.begin(), all.end(), [&](const auto& option) { return option.name == key; });
    return others_.count(key) > 0 || (allowed_.empty() ? is_option : allowed_.count(key) > 0);
  }

  void set(const std::string& name, const std::string& value) {
    if (!isKnown(name)) throw UsageError("unknown option --" + name);
    if (others_.count(withUnderscores(name)) > 0)
      result_.others[withUnderscores(name)] = value;
    else
      result_.options.set(name, value);
  }

  const std::vector<std::string>& words_;
  const std::set<std::string>& allowed_;
  const std::set<std::string>& others_;
  std::size_t next_ = 0;
  CommandWords result_;
};

}  // namespace

CommandWords readCommandWords(const std::vector<std::string>& words, const std::set<std::string>& allowed,
                              const std::set<std::string>& others, std::size_t arguments) {
  return WordReader(words, allowed, others).read(arguments);
}

std::string explained(const std::set<std::string>& allowed) {
  std::string text;
  for (const RunOption& option : runOptions()) {
    if (!allowed.empty() && allowed.count(option.name) == 0) continue;
    std::string name = option.name;
    std::replace(name.begin(), name.end(), '_', '-');
    text += "  --" + name + std::string(name.size() < 18 ? 18 - name.size() : 1, ' ') + option.meaning + "\n";
  }
  return text;
}

}  // namespace tws_launch
