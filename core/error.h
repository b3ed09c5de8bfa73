// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace cvo_slam {

/// Base of every exception this library throws. what() is one line that says what is wrong, where,
/// and what to do about it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An input (file, folder, stream) cannot be used. what() starts with "file:line: " where known.
class InputError : public Error {
 public:
  InputError(const std::filesystem::path& file, const std::string& problem);
  /// `line` counts from 1.
  InputError(const std::filesystem::path& file, long line, const std::string& problem);
};

/// An option has an unknown name, or a value outside its range.
class OptionError : public Error {
 public:
  using Error::Error;
};

/// Data that was read well has no answer to what is asked of it: trajectories that share no time,
/// positions on a line that are to be aligned, ...
class DataError : public Error {
 public:
  using Error::Error;
};

/// A file cannot be written (permissions, full disk).
class OutputError : public Error {
 public:
  OutputError(const std::filesystem::path& file, const std::string& problem);
};

}  // namespace cvo_slam
