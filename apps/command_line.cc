// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/command_line.h"

#include <algorithm>
#include <type_traits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/core/options.h"

namespace cvo_slam {
namespace {

/// The innermost command that the command line names, and how it is called: "cvo_slam run".
struct NamedCommand {
  const CLI::App* app;
  std::string path;
};

NamedCommand named_command(const CLI::App& app) {
  NamedCommand command{&app, app.get_name()};
  while (true) {
    const auto parsed = command.app->get_subcommands();  // those on the command line
    if (parsed.empty()) return command;
    command.app = parsed.back();
    command.path += " " + command.app->get_name();
  }
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(subcommand->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string unknown(const std::string& kind, const std::string& word,
                    const std::vector<std::string>& candidates) {
  return fmt::format("unknown {} '{}'; {}", kind, word, suggestion(word, candidates));
}

std::string leftover_problem(const CLI::App& app, const std::string& word) {
  if (word.starts_with('-')) {
    return unknown("option", word.substr(0, word.find('=')), option_names(app));
  }
  const std::vector<std::string> commands = subcommand_names(app);
  if (commands.empty()) return fmt::format("unexpected argument '{}'", word);
  return unknown("command", word, commands);
}

std::string problem(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  // Words that CLI11 did not understand come first: "a subcommand is required" is mostly a misspelt
  // one.
  const std::vector<std::string> leftover = app.remaining(true);
  if (!leftover.empty()) return leftover_problem(command, leftover.front());
  const std::vector<std::string> commands = subcommand_names(command);
  if (!commands.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    return fmt::format("a command is required: {}", fmt::join(commands, ", "));
  }
  std::string line = error.what();
  std::replace(line.begin(), line.end(), '\n', ' ');
  return line;
}

/// Declares all subcommands, in the order of the help page.
void add_commands(CLI::App& app, Action& action) {
  add_run_command(app, action);
  add_eval_command(app, action);
  add_align_command(app, action);
  add_info_command(app, action);
  add_synth_command(app, action);
  add_optimize_command(app, action);
  add_vocab_command(app, action);
  add_render_command(app, action);
  add_bench_command(app, action);
}

}  // namespace

Argument& Argument::required() {
  option_->required();
  return *this;
}

Argument& Argument::in_range(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Argument& Argument::in_range(double low, double high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Argument& Argument::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

Argument& Argument::show_default() {
  option_->capture_default_str();
  return *this;
}

Argument& Argument::one_value_each() {
  option_->allow_extra_args(false);
  return *this;
}

Argument& Argument::separated_by_commas() {
  option_->delimiter(',');
  return *this;
}

Command::Command(CLI::App& app, const std::string& name, const std::string& help)
    : app_(app.add_subcommand(name, help)) {}

Command::Command(Command& parent, const std::string& name, const std::string& help)
    : Command(*parent.app_, name, help) {}

Argument Command::add(const std::string& names, ArgumentTarget target, const std::string& help) {
  return std::visit(
      [&](auto* value) {
        if constexpr (std::is_same_v<decltype(value), bool*>) {
          return Argument(*app_->add_flag(names, *value, help));
        } else {
          return Argument(*app_->add_option(names, *value, help));
        }
      },
      target);
}

Argument Command::add_words(const std::string& names, const std::vector<std::string>& words,
                            std::function<void(std::size_t)> set, const std::string& help) {
  const auto choose = [words, set = std::move(set)](const std::string& word) {
    set(static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin()));
  };
  // The help text names the words and says what they mean.
  CLI::Option* option = app_->add_option_function<std::string>(names, choose, help);
  option->check(CLI::IsMember(words).description(""));
  return Argument(*option);
}

void Command::require_subcommand() { app_->require_subcommand(1); }

void Command::on_parsed(Action& action, Action run) {
  app_->callback([&action, run = std::move(run)] { action = run; });
}

Action parse_command_line(int argc, char** argv) {
  CLI::App app{"cvo_slam: RGB-D SLAM with Continuous Visual Odometry", "cvo_slam"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "cvo_slam " CVO_SLAM_VERSION);
  Action action;
  add_commands(app, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& page) {
    const int code = app.exit(page);  // prints the help page or the version
    return [code] { return code; };
  } catch (const CLI::ParseError& error) {
    throw OptionError(usage_message(app, error));
  }
  return action;
}

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const NamedCommand command = named_command(app);
  return fmt::format("{} (see {} --help)", problem(app, *command.app, error), command.path);
}

}  // namespace cvo_slam
