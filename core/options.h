// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cvo_slam {

/// Closed interval of permitted values.
template <typename T>
struct Range {
  T min = std::numeric_limits<T>::lowest();  ///< the default is no limit
  T max = std::numeric_limits<T>::max();     ///< the default is no limit
};

/// One option of an options struct, with its type erased, for YAML readers, `--set`, help pages and
/// language bindings.
struct Option {
  std::string key;      ///< dotted path, e.g. "registration.solver"; see OptionSet::expert()
  std::string unit;     ///< "m", "rad", "px", ... or empty
  std::string allowed;  ///< range or choices, for people
  std::string doc;      ///< what the option means, in one or two sentences
  /// Returns the present value as a text that `set` accepts.
  std::function<std::string()> get;
  /// Parses and stores a value; throws OptionError if the text is not a permitted value.
  std::function<void(std::string_view)> set;
};

/// The options of a struct by name. Each options struct has one function
/// `OptionSet describe(Struct&)` which lists its members once; YAML files, `--set key=value`,
/// range checks, `--dump-config` and the manual's tables are all made from that list.
/// The set refers to the described struct, which must outlive it. Each add() returns the set.
class OptionSet {
 public:
  /// Texts and values of an enumeration.
  template <typename E>
  using Choices = std::vector<std::pair<std::string, E>>;

  /// Adds an option that is true or false.
  OptionSet& add(const std::string& key, bool& value, std::string doc);
  ///@{
  /// Adds a number; `unit` is empty if it has none.
  OptionSet& add(const std::string& key, int& value, Range<int> range, std::string unit,
                 std::string doc);
  OptionSet& add(const std::string& key, double& value, Range<double> range, std::string unit,
                 std::string doc);
  ///@}
  ///@{
  /// Adds a list, which is written "[a, b, c]" and must not be empty; `range` holds for each
  /// element.
  OptionSet& add(const std::string& key, std::vector<int>& value, Range<int> range,
                 std::string unit, std::string doc);
  OptionSet& add(const std::string& key, std::vector<double>& value, Range<double> range,
                 std::string unit, std::string doc);
  ///@}
  /// Adds a value of an enumeration, which is written as its text in `choices`.
  template <typename E>
  OptionSet& add(const std::string& key, E& value, Choices<E> choices, const std::string& doc);
  /// Adds all options of a nested struct, their keys prefixed by "prefix.".
  OptionSet& add(const std::string& prefix, const OptionSet& nested);
  /// All options of another set, with the keys they have.
  OptionSet& add(const OptionSet& other);
  /// Marks all options that are added after this call as expert options, which are not needed for
  /// good results: their keys start with "expert.", before all prefixes.
  OptionSet& expert();

  /// Returns the options in the order in which they were added.
  [[nodiscard]] const std::vector<Option>& options() const& { return options_; }
  /// Returns the options of a temporary set by value, so that `for (... : describe(x).options())`
  /// does not dangle.
  [[nodiscard]] std::vector<Option> options() && { return std::move(options_); }
  /// Returns the value of an option as text. Throws OptionError for an unknown key.
  [[nodiscard]] std::string get(std::string_view key) const;
  /// Sets an option from a text. Throws OptionError for an unknown key (the message names a near
  /// one) or a bad value.
  void set(std::string_view key, std::string_view text) const;
  /// Throws OptionError if a value that code has set without set() is out of range.
  void check() const;

 private:
  OptionSet& add_choice(std::string key, std::vector<std::string> names,
                        const std::function<std::size_t()>& index_of_value,
                        const std::function<void(std::size_t)>& set_index, std::string doc);
  [[nodiscard]] const Option& find(std::string_view key) const;

  OptionSet& append(Option option);

  std::vector<Option> options_;
  bool expert_ = false;  // options that are added now are expert options
};

template <typename E>
OptionSet& OptionSet::add(const std::string& key, E& value, Choices<E> choices,
                          const std::string& doc) {
  std::vector<std::string> names;
  for (const auto& choice : choices) names.push_back(choice.first);
  const auto index_of_value = [&value, choices] {
    std::size_t i = 0;
    while (i < choices.size() && choices[i].second != value) ++i;
    return i;
  };
  const auto set_index = [&value, choices](std::size_t i) { value = choices[i].second; };
  return add_choice(key, std::move(names), index_of_value, set_index, doc);
}

/// Returns what to do about an unknown word, for the end of an error message: "did you mean 'run'?"
/// with the candidate of the smallest edit distance, or the list of all candidates if even that one
/// differs in more than half of the word's letters (rounded up).
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates);

}  // namespace cvo_slam
