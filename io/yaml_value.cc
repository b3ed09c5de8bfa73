// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_value.h"

#include <algorithm>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/core/options.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_internal.h"

namespace cvo_slam {

/// Copies the nodes of yaml-cpp, whose lookups are slow and whose headers embedders need not have.
class YamlConverter {
 public:
  explicit YamlConverter(const std::filesystem::path& file)
      : file_(std::make_shared<const std::filesystem::path>(file)) {}

  [[nodiscard]] YamlValue convert(const YAML::Node& node) const {
    YamlValue value;
    value.file_ = file_;
    value.line_ = line_of(node);
    if (node.IsScalar()) {
      value.kind_ = YamlValue::Kind::kWord;
      value.word_ = node.Scalar();
    } else if (node.IsSequence()) {
      value.kind_ = YamlValue::Kind::kList;
      for (const auto& item : node) value.list_.push_back(convert(item));
    } else if (node.IsMap()) {
      value.kind_ = YamlValue::Kind::kMap;
      for (const auto& entry : node) add_entry(entry.first, entry.second, value);
    }
    return value;
  }

 private:
  void add_entry(const YAML::Node& key, const YAML::Node& node, YamlValue& map) const {
    if (!key.IsScalar()) throw InputError(*file_, line_of(key), "a key must be a plain word");
    if (map.find(key.Scalar()) != nullptr) {
      throw InputError(*file_, line_of(key),
                       fmt::format("key '{}' is given twice; remove one", key.Scalar()));
    }
    YamlValue value = convert(node);
    // An empty value has no line of its own.
    if (value.kind_ == YamlValue::Kind::kEmpty) value.line_ = line_of(key);
    map.map_.emplace_back(key.Scalar(), std::move(value));
  }

  std::shared_ptr<const std::filesystem::path> file_;
};

YamlValue YamlValue::read(const std::filesystem::path& file) {
  return parse(read_file(file), file);
}

YamlValue YamlValue::parse(const std::string& text, const std::filesystem::path& file) {
  return YamlConverter(file).convert(parse_yaml(text, file));
}

void YamlValue::fail(const std::string& problem) const { throw InputError(*file_, line_, problem); }

const std::string& YamlValue::word(const std::string& what) const {
  if (kind_ != Kind::kWord) fail(fmt::format("{}: expected a word", what));
  return word_;
}

double YamlValue::number(const std::string& what) const {
  const auto value = kind_ == Kind::kWord ? parse_finite(word_) : std::nullopt;
  if (!value) fail(fmt::format("{}: expected a number", what));
  return *value;
}

std::vector<double> YamlValue::numbers(const std::string& what, std::size_t count) const {
  if (kind_ != Kind::kList || list_.size() != count) {
    fail(fmt::format("{}: expected a list of {} numbers", what, count));
  }
  std::vector<double> values;
  for (const auto& item : list_) values.push_back(item.number(what));
  return values;
}

bool YamlValue::flag(const std::string& what) const {
  if (kind_ == Kind::kWord && word_ == "true") return true;
  if (kind_ == Kind::kWord && word_ == "false") return false;
  fail(fmt::format("{}: expected true or false", what));
}

const std::vector<YamlValue>& YamlValue::list(const std::string& what) const {
  if (kind_ != Kind::kList) fail(fmt::format("{}: expected a list", what));
  return list_;
}

const std::vector<std::pair<std::string, YamlValue>>& YamlValue::map(
    const std::string& what) const {
  if (kind_ != Kind::kMap) fail(fmt::format("{}: expected 'key: value' entries", what));
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
    value.fail(fmt::format("{}: unknown key '{}'; {}", what, key, suggestion(key, known)));
  }
}

}  // namespace cvo_slam
