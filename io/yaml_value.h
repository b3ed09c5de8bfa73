// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cvo_slam {

/// A value of a YAML file: a word, a list or a map. Knows its line, so that whoever reads it can
/// say where something is wrong. All members named `what` are for messages.
class YamlValue {
 public:
  /// The map that a whole file is. Throws InputError where the file cannot be read or is not YAML,
  /// is not a map, or gives a key twice.
  [[nodiscard]] static YamlValue read(const std::filesystem::path& file);
  /// The same of a text; `file` is for messages.
  [[nodiscard]] static YamlValue parse(const std::string& text, const std::filesystem::path& file);

  /// Throws InputError "file:line: problem".
  [[noreturn]] void fail(const std::string& problem) const;

  // Each throws InputError where the value is something else.
  [[nodiscard]] const std::string& word(const std::string& what) const;
  [[nodiscard]] double number(const std::string& what) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& what, std::size_t count) const;
  [[nodiscard]] bool flag(const std::string& what) const;
  [[nodiscard]] const std::vector<YamlValue>& list(const std::string& what) const;
  /// The entries of a map in the order of the file.
  [[nodiscard]] const std::vector<std::pair<std::string, YamlValue>>& map(
      const std::string& what) const;

  [[nodiscard]] bool is_word() const { return kind_ == Kind::kWord; }
  /// The value of a map's key; null where there is none, or where this is no map.
  [[nodiscard]] const YamlValue* find(const std::string& key) const;
  /// Throws InputError where the key is missing.
  [[nodiscard]] const YamlValue& require(const std::string& key, const std::string& what) const;
  /// Throws InputError where this is no map, or has a key that is not `known`; the message gives
  /// the nearest one.
  void check_keys(const std::vector<std::string>& known, const std::string& what) const;

  /// From 1.
  [[nodiscard]] long line() const { return line_; }

 private:
  friend class YamlConverter;
  enum class Kind { kEmpty, kWord, kList, kMap };

  Kind kind_ = Kind::kEmpty;
  std::shared_ptr<const std::filesystem::path> file_;
  long line_ = 0;
  std::string word_;
  std::vector<YamlValue> list_;
  std::vector<std::pair<std::string, YamlValue>> map_;
};

}  // namespace cvo_slam
