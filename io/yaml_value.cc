// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_value.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <utf8.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/numbers.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {

/// Makes a value from the events of yaml-cpp's parser. Its tree of nodes is not used: making it
/// ends the program for a value that contains itself, its look-ups are slow, it keeps the first of
/// two equal keys without an error, and users of the library need not have its headers.
class YamlBuilder : public YAML::EventHandler {
 public:
  explicit YamlBuilder(const std::filesystem::path& file)
      : file_(std::make_shared<const std::filesystem::path>(file)) {}

  /// Returns the map of the file, or an empty value if it has none.
  [[nodiscard]] YamlValue root() && {
    if (!root_) return empty_value(1);
    if (root_->is_map() || root_->is_empty()) return std::move(*root_);
    throw InputError(*file_, root_->line(), "expected 'key: value' lines");
  }

  void OnDocumentStart(const YAML::Mark& /*mark*/) override { ++documents_; }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    if (documents_ > 1 && open_.empty()) return;  // behind a last "---"
    begin_value(mark);
    if (expects_key()) fail_at(mark, "a key must be a plain word");
    // An empty value has no line of its own.
    add(empty_value(open_.empty() ? 1 : key_line_or(line_of(mark))));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                const std::string& word) override {
    begin_value(mark);
    if (expects_key()) return begin_key(mark, word);
    YamlValue value = value_at(mark, YamlValue::Kind::kWord);
    value.word_ = word;
    add(std::move(value));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/,
                       YAML::anchor_t /*anchor*/, YAML::EmitterStyle::value /*style*/) override {
    begin_collection(mark, YamlValue::Kind::kList);
  }
  void OnSequenceEnd() override { end_collection(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    begin_collection(mark, YamlValue::Kind::kMap);
  }
  void OnMapEnd() override { end_collection(); }

  // Aliases may double a value on each line, or make it part of itself.
  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    fail_at(mark, fmt::format("the anchor '&{}' is not supported; write the value where it is "
                              "used",
                              name));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    fail_at(mark, "an alias ('*name') is not supported; write the value itself");
  }

 private:
  /// A list or map whose end has not come yet.
  struct Open {
    YamlValue value;
    std::set<std::string> keys;
    bool has_key = false;  ///< true if a key waits for its value
    std::string key;
    long key_line = 1;
  };

  static long line_of(const YAML::Mark& mark) { return mark.line + 1; }

  [[noreturn]] void fail_at(const YAML::Mark& mark, const std::string& problem) const {
    throw InputError(*file_, line_of(mark), problem);
  }

  [[nodiscard]] long key_line_or(long line) const {
    return !open_.empty() && open_.back().has_key ? open_.back().key_line : line;
  }

  [[nodiscard]] YamlValue empty_value(long line) const {
    YamlValue value;
    value.file_ = file_;
    value.line_ = value.key_line_ = line;
    return value;
  }

  [[nodiscard]] YamlValue value_at(const YAML::Mark& mark, YamlValue::Kind kind) const {
    YamlValue value = empty_value(line_of(mark));
    value.kind_ = kind;
    value.key_line_ = key_line_or(value.line_);
    return value;
  }

  [[nodiscard]] bool expects_key() const {
    return !open_.empty() && open_.back().value.is_map() && !open_.back().has_key;
  }

  void begin_value(const YAML::Mark& mark) const {
    if (documents_ > 1) {
      fail_at(mark, "a second document begins before this ('---'); keep one in the file");
    }
  }

  void begin_key(const YAML::Mark& mark, const std::string& word) {
    Open& map = open_.back();
    if (!map.keys.insert(word).second) {
      fail_at(mark, fmt::format("key '{}' is given twice; remove one", word));
    }
    map.has_key = true;
    map.key = word;
    map.key_line = line_of(mark);
  }

  void begin_collection(const YAML::Mark& mark, YamlValue::Kind kind) {
    // More than any file of this library needs, and less than fills the stack of a parser.
    constexpr std::size_t kDeepest = 32;
    begin_value(mark);
    if (expects_key()) fail_at(mark, "a key must be a plain word");
    if (open_.size() == kDeepest) {
      fail_at(mark, fmt::format("values are nested too deeply; {} levels are possible", kDeepest));
    }
    Open open;
    open.value = value_at(mark, kind);
    open_.push_back(std::move(open));
  }

  void end_collection() {
    YamlValue value = std::move(open_.back().value);
    open_.pop_back();
    add(std::move(value));
  }

  void add(YamlValue value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().value.is_map()) {
      open_.back().value.map_.emplace_back(std::move(open_.back().key), std::move(value));
      open_.back().has_key = false;
    } else {
      open_.back().value.list_.push_back(std::move(value));
    }
  }

  std::shared_ptr<const std::filesystem::path> file_;
  int documents_ = 0;
  std::vector<Open> open_;  // from the outermost to the innermost
  std::optional<YamlValue> root_;
};

namespace {

/// Refuses bytes that are no UTF-8 and control characters, one of which yaml-cpp takes for the end
/// of the file.
void check_characters(const std::string& text, const std::filesystem::path& file) {
  const auto is_control = [](char c) {
    return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
  };
  const auto invalid = utf8::find_invalid(text.begin(), text.end());
  const auto bad = std::min(invalid, std::find_if(text.begin(), text.end(), is_control));
  if (bad == text.end()) return;
  throw InputError(file, 1 + std::count(text.begin(), bad, '\n'),
                   "has bytes that are no text; save the file as UTF-8");
}

}  // namespace

YamlValue YamlValue::read(const std::filesystem::path& file) {
  return parse(read_file(file), file);
}

YamlValue YamlValue::parse(std::string text, const std::filesystem::path& file) {
  text = text_of(text, file);
  check_characters(text, file);
  if (text.starts_with("%YAML:")) text.front() = '#';
  YamlBuilder builder(file);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    // At a comma outside of any value yaml-cpp 0.7 makes empty documents without an end.
    constexpr int kMostDocuments = 3;  // the file's, and empty ones behind a last "---"
    for (int i = 0; parser.HandleNextDocument(builder); ++i) {
      if (i == kMostDocuments) {
        throw InputError(file, "is not YAML, or has several documents; keep one in the file");
      }
    }
  } catch (const YAML::Exception& error) {
    throw InputError(file, error.mark.line + 1, fmt::format("not valid YAML: {}", error.msg));
  }
  return std::move(builder).root();
}

void YamlValue::fail(const std::string& problem) const { throw InputError(*file_, line_, problem); }

void YamlValue::fail_at_key(const std::string& problem) const {
  throw InputError(*file_, key_line_, problem);
}

void YamlValue::fail_expected(const std::string& what, const std::string& expected) const {
  if (is_empty()) fail(fmt::format("{}: a value is missing", what));
  fail(fmt::format("{}: expected {}", what, expected));
}

const std::string& YamlValue::word(const std::string& what) const {
  if (kind_ != Kind::kWord) fail_expected(what, "a word");
  return word_;
}

double YamlValue::number(const std::string& what) const {
  const auto value = kind_ == Kind::kWord ? parse_finite(word_) : std::nullopt;
  if (!value && kind_ == Kind::kWord && has_decimal_comma(word_)) {
    fail(fmt::format("{}: {}", what, number_problem(word_)));
  }
  if (!value) fail_expected(what, "a number");
  return *value;
}

std::vector<double> YamlValue::numbers(const std::string& what, std::size_t count) const {
  if (kind_ != Kind::kList || list_.size() != count) {
    fail_expected(what, fmt::format("a list of {} numbers", count));
  }
  std::vector<double> values;
  for (const auto& item : list_) values.push_back(item.number(what));
  return values;
}

bool YamlValue::flag(const std::string& what) const {
  if (kind_ == Kind::kWord && word_ == "true") return true;
  if (kind_ == Kind::kWord && word_ == "false") return false;
  fail_expected(what, "true or false");
}

const std::vector<YamlValue>& YamlValue::list(const std::string& what) const {
  if (kind_ != Kind::kList) fail_expected(what, "a list");
  return list_;
}

const std::vector<std::pair<std::string, YamlValue>>& YamlValue::map(
    const std::string& what) const {
  if (kind_ != Kind::kMap) fail_expected(what, "'key: value' entries");
  return map_;
}

const YamlValue* YamlValue::find(const std::string& key) const {
  const auto entry =
      std::find_if(map_.begin(), map_.end(), [&](const auto& e) { return e.first == key; });
  return entry == map_.end() ? nullptr : &entry->second;
}

const YamlValue& YamlValue::require(const std::string& key, const std::string& what) const {
  const YamlValue* value = find(key);
  if (value == nullptr) fail(fmt::format("{}: the key '{}' is missing", what, key));
  return *value;
}

void YamlValue::check_keys(const std::vector<std::string>& known, const std::string& what) const {
  for (const auto& [key, value] : map(what)) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    value.fail_at_key(fmt::format("{}: unknown key '{}'; {}", what, key, suggestion(key, known)));
  }
}

std::string to_yaml_word(const std::string& text) { return YAML::Dump(YAML::Node(text)); }

}  // namespace cvo_slam
