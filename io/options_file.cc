// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/options_file.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/text_internal.h"
#include "cvo_slam/io/yaml_value.h"

namespace cvo_slam {
namespace {

struct Setting {
  std::string key;
  const YamlValue* value = nullptr;
};

/// Returns a word as it is written, a list of words as "[a, b]".
std::string value_text(const Setting& setting) {
  const YamlValue& value = *setting.value;
  if (value.is_word()) return value.word(setting.key);
  std::vector<std::string> items;
  for (const auto& item : value.list(setting.key)) items.push_back(item.word(setting.key));
  return fmt::format("[{}]", fmt::join(items, ", "));
}

/// Appends all values below `map`, the keys of nested maps joined by dots.
void collect(const YamlValue& map, const std::string& prefix, std::vector<Setting>& settings) {
  for (const auto& [name, value] : map.map("options")) {
    if (value.is_map()) {
      collect(value, prefix + name + ".", settings);
    } else {
      settings.push_back({prefix + name, &value});
    }
  }
}

/// Throws InputError if an option is set twice: "a: {b: 1}" and "a.b: 2" in one file are different
/// keys to YAML.
void check_distinct(std::vector<Setting> settings) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return a.key < b.key; });
  const auto twice =
      std::adjacent_find(settings.begin(), settings.end(),
                         [](const Setting& a, const Setting& b) { return a.key == b.key; });
  if (twice == settings.end()) return;
  std::next(twice)->value->fail_at_key(
      fmt::format("option '{}' is set twice; remove one", twice->key));
}

/// Returns the documentation, then "[unit; range]", as comment lines behind `indent`, each of at
/// most 100 characters unless a word is longer.
std::string comment_of(const Option& option, const std::string& indent) {
  constexpr std::size_t kWidth = 100;
  const std::string range = option.unit.empty()
                                ? fmt::format("[{}]", option.allowed)
                                : fmt::format("[{}; {}]", option.unit, option.allowed);
  std::string comment;
  std::string line = indent + "#";
  for (const auto& word : split_words(option.doc)) {
    if (line.size() + 1 + word.size() > kWidth) {
      comment += line + "\n";
      line = indent + "#";
    }
    line += " " + word;
  }
  return comment + line + "\n" + indent + "# " + range + "\n";
}

/// Returns the options of one map, whose keys all start with the same `prefix` characters. A nested
/// map stands at the place of its first option and holds all options that belong to it.
std::string map_to_yaml(const std::vector<const Option*>& options, std::size_t prefix,
                        bool comments, const std::string& indent) {
  std::string text;
  std::set<std::string> nested_maps;
  for (const Option* option : options) {
    const std::size_t dot = option->key.find('.', prefix);
    if (dot == std::string::npos) {
      if (comments) text += comment_of(*option, indent);
      text += fmt::format("{}{}: {}\n", indent, option->key.substr(prefix), option->get());
      continue;
    }
    const std::string nested = option->key.substr(0, dot + 1);
    if (!nested_maps.insert(nested).second) continue;
    std::vector<const Option*> members;
    std::copy_if(options.begin(), options.end(), std::back_inserter(members),
                 [&](const Option* other) { return other->key.starts_with(nested); });
    text += fmt::format("{}{}:\n", indent, option->key.substr(prefix, dot - prefix));
    text += map_to_yaml(members, dot + 1, comments, indent + "  ");
  }
  return text;
}

}  // namespace

void read_options(const std::filesystem::path& file, const OptionSet& options) {
  const YamlValue root = YamlValue::read(file);
  if (root.is_empty()) return;
  std::vector<Setting> settings;
  collect(root, "", settings);
  check_distinct(settings);
  for (const auto& setting : settings) {
    try {
      options.set(setting.key, value_text(setting));
    } catch (const OptionError& error) {
      setting.value->fail_at_key(error.what());
    }
  }
}

std::string options_to_yaml(const OptionSet& options, bool comments) {
  std::vector<const Option*> all;
  for (const auto& option : options.options()) all.push_back(&option);
  return map_to_yaml(all, 0, comments, "");
}

}  // namespace cvo_slam
