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

/// A value of a YAML file: a word, a list, a map, or nothing. It knows its place in the file, so
/// that the code that reads it can say where a mistake is. The arguments named `what` are names for
/// error messages. The functions word() to map() throw InputError if the value has another type.
class YamlValue {
 public:
  /// Returns the map that a whole file is, or an empty value for an empty file. Throws InputError
  /// with the line if the file cannot be read, is not YAML, is not a map, has a key twice, several
  /// documents, more than 32 levels, or an anchor or alias.
  [[nodiscard]] static YamlValue read(const std::filesystem::path& file);
  /// Does the same with text; `file` is used in error messages only. The line "%YAML:1.0" of
  /// OpenCV's files, which is not YAML, is accepted.
  [[nodiscard]] static YamlValue parse(std::string text, const std::filesystem::path& file);

  /// Returns true for an empty file, and for a key or a list entry without a value.
  [[nodiscard]] bool is_empty() const { return kind_ == Kind::kEmpty; }
  /// Returns true for a word: text, a number, true or false.
  [[nodiscard]] bool is_word() const { return kind_ == Kind::kWord; }
  /// Returns true for entries `key: value`.
  [[nodiscard]] bool is_map() const { return kind_ == Kind::kMap; }

  /// Returns the text of a word, without its quotes.
  [[nodiscard]] const std::string& word(const std::string& what) const;
  /// Returns a finite number.
  [[nodiscard]] double number(const std::string& what) const;
  /// Returns a list of exactly `count` finite numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& what, std::size_t count) const;
  /// Returns the value of a word that is `true` or `false`.
  [[nodiscard]] bool flag(const std::string& what) const;
  /// Returns the entries of a list.
  [[nodiscard]] const std::vector<YamlValue>& list(const std::string& what) const;
  /// Returns the entries of a map in the order of the file.
  [[nodiscard]] const std::vector<std::pair<std::string, YamlValue>>& map(
      const std::string& what) const;

  /// Returns the value of a key, or a null pointer if there is no such key or this is no map.
  [[nodiscard]] const YamlValue* find(const std::string& key) const;
  /// Returns the value of a key. Throws InputError if there is no such key.
  [[nodiscard]] const YamlValue& require(const std::string& key, const std::string& what) const;
  /// Throws InputError if this is no map or has a key that is not in `known`; the message suggests
  /// the nearest known key.
  void check_keys(const std::vector<std::string>& known, const std::string& what) const;

  /// Line in the file, from 1. A map or list that starts below its key has the line of its first
  /// entry.
  [[nodiscard]] long line() const { return line_; }
  /// Throws InputError "file:line: problem" with the line of this value.
  [[noreturn]] void fail(const std::string& problem) const;
  /// Throws InputError with the line of the key that this is the value of.
  [[noreturn]] void fail_at_key(const std::string& problem) const;

 private:
  friend class YamlBuilder;
  enum class Kind { kEmpty, kWord, kList, kMap };

  [[noreturn]] void fail_expected(const std::string& what, const std::string& expected) const;

  Kind kind_ = Kind::kEmpty;
  std::shared_ptr<const std::filesystem::path> file_;
  long line_ = 1;
  long key_line_ = 1;
  std::string word_;
  std::vector<YamlValue> list_;
  std::vector<std::pair<std::string, YamlValue>> map_;
};

/// Returns text as a YAML scalar, with quotes if it needs them.
[[nodiscard]] std::string to_yaml_word(const std::string& text);

}  // namespace cvo_slam
