// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/usage.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  // First what CLI11 did not understand: "a subcommand is required" is mostly a misspelt one.
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

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const NamedCommand command = named_command(app);
  return fmt::format("{} (see {} --help)", problem(app, *command.app, error), command.path);
}

}  // namespace cvo_slam
