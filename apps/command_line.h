// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Declaring subcommands and their options. CLI11 parses them, behind this header: compiling CLI11
// takes ten seconds, and only command_line.cc pays for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace cvo_slam {

/// What a parsed subcommand does; the result is the exit code of the program.
using Action = std::function<int()>;

/// Exit codes of the program (docs/architecture.md, "The command line").
enum ExitCode : int {
  kDone = 0,
  kFailed = 1,
  kBadInput = 2,
  kTrackingLost = 3,
  kInterrupted = 130,
  kTerminated = 143,
};

/// An option or positional argument that was just declared; the functions restrict it further.
class Argument {
 public:
  explicit Argument(CLI::Option& option) : option_(&option) {}

  Argument& required();
  /// Restricts a number to low <= value <= high.
  Argument& in_range(int low, int high);
  Argument& in_range(double low, double high);
  /// Restricts a word to these.
  Argument& one_of(const std::vector<std::string>& words);
  /// Makes the help page show the variable's present value as the default.
  Argument& show_default();
  /// Takes one value each time the option is given, so that a positional argument may follow.
  Argument& one_value_each();
  /// Splits a list at commas.
  Argument& separated_by_commas();

 private:
  CLI::Option* option_;
};

/// The variable that receives an option's value. A bool is a flag, a vector takes several values.
using ArgumentTarget =
    std::variant<bool*, int*, std::uint32_t*, double*, std::string*, std::filesystem::path*,
                 std::optional<int>*, std::optional<double>*, std::vector<std::string>*,
                 std::vector<std::filesystem::path>*>;

/// A subcommand while its options are declared.
class Command {
 public:
  /// Adds a subcommand to the program or, as in `bench odometry`, to another subcommand.
  Command(CLI::App& app, const std::string& name, const std::string& help);
  Command(Command& parent, const std::string& name, const std::string& help);

  /// Declares an option ("-o,--out") or a positional argument ("dataset").
  Argument add(const std::string& names, ArgumentTarget target, const std::string& help);

  /// Declares an option whose words stand for values of an enumeration.
  template <typename T, typename E>
  Argument add_choice(const std::string& names, T* target,
                      const std::vector<std::pair<std::string, E>>& choices,
                      const std::string& help) {
    std::vector<std::string> words;
    std::vector<E> values;
    for (const auto& [word, value] : choices) {
      words.push_back(word);
      values.push_back(value);
    }
    return add_words(
        names, words, [target, values](std::size_t i) { *target = values[i]; }, help);
  }

  /// Demands that one of its own subcommands is named.
  void require_subcommand();

  /// `action` becomes `run` when the command line names this subcommand.
  void on_parsed(Action& action, Action run);

 private:
  Argument add_words(const std::string& names, const std::vector<std::string>& words,
                     std::function<void(std::size_t)> set, const std::string& help);

  CLI::App* app_;
};

// Each declares one subcommand and its options on `app`; `action` is set when the command line
// names it.

void add_run_command(CLI::App& app, Action& action);
void add_eval_command(CLI::App& app, Action& action);
void add_align_command(CLI::App& app, Action& action);
void add_info_command(CLI::App& app, Action& action);
void add_synth_command(CLI::App& app, Action& action);
void add_optimize_command(CLI::App& app, Action& action);
void add_vocab_command(CLI::App& app, Action& action);
void add_render_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);

/// Returns what the command line asks for. A help page and the version are printed at once. Throws
/// OptionError with the line of usage_message() if the command line is wrong.
[[nodiscard]] Action parse_command_line(int argc, char** argv);

/// Returns what is wrong with a command line that `app` could not parse, in one line: the problem,
/// the nearest name if one is unknown, and whose help page to read.
[[nodiscard]] std::string usage_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace cvo_slam
