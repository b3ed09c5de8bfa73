// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_value.h"

#include <algorithm>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {

/// Copies the nodes of yaml-cpp: its look-ups are slow, it keeps the first of two equal keys
/// without an error, and users of the library need not have its headers.
class YamlConverter {
 public:
  explicit YamlConverter(const std::filesystem::path& file)
      : file_(std::make_shared<const std::filesystem::path>(file)) {}

  [[nodiscard]] YamlValue convert_root(const YAML::Node& node) const {
    if (!node.IsMap() && !node.IsNull()) {
      throw InputError(*file_, line_of(node), "expected 'key: value' lines");
    }
    return convert(node, node.IsNull() ? 1 : line_of(node), 0);
  }

 private:
  static long line_of(const YAML::Node& node) { return node.Mark().line + 1; }

  /// `line` is the line of the node's key.
  [[nodiscard]] YamlValue convert(const YAML::Node& node, long line, int depth) const {
    constexpr int kDeepest = 32;  // an alias may make a value part of itself
    if (depth > kDeepest) throw InputError(*file_, line, "values are nested too deeply");
    YamlValue value;
    value.file_ = file_;
    value.key_line_ = line;
    value.line_ = node.IsNull() ? line : line_of(node);  // an empty value has no line of its own
    if (node.IsScalar()) {
      value.kind_ = YamlValue::Kind::kWord;
      value.word_ = node.Scalar();
    } else if (node.IsSequence()) {
      value.kind_ = YamlValue::Kind::kList;
      for (const auto& item : node) {
        value.list_.push_back(convert(item, line_of(item), depth + 1));
      }
    } else if (node.IsMap()) {
      value.kind_ = YamlValue::Kind::kMap;
      for (const auto& entry : node) {
        value.map_.emplace_back(key_of(entry.first, value),
                                convert(entry.second, line_of(entry.first), depth + 1));
      }
    }
    return value;
  }

  [[nodiscard]] const std::string& key_of(const YAML::Node& key, const YamlValue& map) const {
    if (!key.IsScalar()) throw InputError(*file_, line_of(key), "a key must be a plain word");
    if (map.find(key.Scalar()) == nullptr) return key.Scalar();
    throw InputError(*file_, line_of(key),
                     fmt::format("key '{}' is given twice; remove one", key.Scalar()));
  }

  std::shared_ptr<const std::filesystem::path> file_;
};

YamlValue YamlValue::read(const std::filesystem::path& file) {
  return parse(read_file(file), file);
}

YamlValue YamlValue::parse(std::string text, const std::filesystem::path& file) {
  if (text.starts_with("%YAML:")) text.front() = '#';
  try {
    return YamlConverter(file).convert_root(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw InputError(file, error.mark.line + 1, fmt::format("not valid YAML: {}", error.msg));
  }
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
