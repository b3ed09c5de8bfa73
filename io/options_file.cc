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
#include "cvo_slam/io/yaml_internal.h"

namespace cvo_slam {
namespace {

struct Setting {
  std::string key;
  std::string value;
  long line = 0;
};

/// A scalar as it is written, a list as "[a, b]".
std::string value_text(const YAML::Node& node, const std::string& key, long line,
                       const std::filesystem::path& file) {
  if (node.IsScalar()) return node.Scalar();
  if (!node.IsSequence()) {
    throw InputError(file, line, fmt::format("{}: a value is missing", key));
  }
  std::vector<std::string> items;
  for (const auto& item : node) {
    if (!item.IsScalar()) {
      throw InputError(file, line_of(item), fmt::format("{}: a list must have plain values", key));
    }
    items.push_back(item.Scalar());
  }
  return fmt::format("[{}]", fmt::join(items, ", "));
}

/// All values below `map`, the keys of nested maps joined by dots.
void collect(const YAML::Node& map, const std::string& prefix, const std::filesystem::path& file,
             std::vector<Setting>& settings) {
  for (const auto& entry : map) {
    const std::string key = prefix + entry.first.Scalar();
    if (entry.second.IsMap()) {
      collect(entry.second, key + ".", file, settings);
    } else {
      const long line = line_of(entry.first);
      settings.push_back({key, value_text(entry.second, key, line, file), line});
    }
  }
}

/// "a: {b: 1}" and "a.b: 2" in one file are different keys to YAML, but one option.
void check_distinct(std::vector<Setting> settings, const std::filesystem::path& file) {
  std::stable_sort(settings.begin(), settings.end(),
                   [](const Setting& a, const Setting& b) { return a.key < b.key; });
  const auto twice =
      std::adjacent_find(settings.begin(), settings.end(),
                         [](const Setting& a, const Setting& b) { return a.key == b.key; });
  if (twice == settings.end()) return;
  throw InputError(file, std::next(twice)->line,
                   fmt::format("option '{}' is set twice; remove one", twice->key));
}

/// The documentation, then "[unit; range]", as comment lines behind `indent`, of 100 characters at
/// most where words allow.
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

/// Writes the options of one map, whose keys all start with the same `prefix` characters. A nested
/// map is written where its first option stands, with all that belong to it.
void write_map(const std::vector<const Option*>& options, std::size_t prefix, bool comments,
               const std::string& indent, std::string& text) {
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
    write_map(members, dot + 1, comments, indent + "  ", text);
  }
}

}  // namespace

void read_options(const std::filesystem::path& file, const OptionSet& options) {
  std::vector<Setting> settings;
  collect(load_yaml(file), "", file, settings);
  check_distinct(settings, file);
  for (const auto& setting : settings) {
    try {
      options.set(setting.key, setting.value);
    } catch (const OptionError& error) {
      throw InputError(file, setting.line, error.what());
    }
  }
}

std::string options_to_yaml(const OptionSet& options, bool comments) {
  std::vector<const Option*> all;
  for (const auto& option : options.options()) all.push_back(&option);
  std::string text;
  write_map(all, 0, comments, "", text);
  return text;
}

}  // namespace cvo_slam
