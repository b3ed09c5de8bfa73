// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/yaml_internal.h"

#include <set>

#include <fmt/format.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/files.h"
#include "cvo_slam/io/text_internal.h"

namespace cvo_slam {
namespace {

/// yaml-cpp keeps the first of two equal keys without a word.
void check_keys(const YAML::Node& node, const std::filesystem::path& file) {
  if (!node.IsMap()) return;
  std::set<std::string> keys;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) {
      throw InputError(file, line_of(entry.first), "a key must be a plain word");
    }
    const std::string& key = entry.first.Scalar();
    if (!keys.insert(key).second) {
      throw InputError(file, line_of(entry.first),
                       fmt::format("key '{}' is given twice; remove one", key));
    }
    check_keys(entry.second, file);
  }
}

}  // namespace

YAML::Node parse_yaml(std::string text, const std::filesystem::path& file) {
  if (text.starts_with("%YAML:")) text.front() = '#';
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap() && !root.IsNull()) {
      throw InputError(file, line_of(root), "expected 'key: value' lines");
    }
    check_keys(root, file);
    return root;
  } catch (const YAML::Exception& error) {
    throw InputError(file, error.mark.line + 1, fmt::format("not valid YAML: {}", error.msg));
  }
}

YAML::Node load_yaml(const std::filesystem::path& file) {
  return parse_yaml(read_file(file), file);
}

long line_of(const YAML::Node& node) { return node.Mark().line + 1; }

}  // namespace cvo_slam
