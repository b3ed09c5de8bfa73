// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

/// RGB-D SLAM with Continuous Visual Odometry. Slam (slam/slam.h) is the place to start.
namespace cvo_slam {

/// Base class of every exception that this library throws. what() is one line that says what is
/// wrong, where, and what to do about it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An input (file, folder, stream) cannot be used. what() starts with "file:line: " if the line is
/// known.
class InputError : public Error {
 public:
  /// what() is "file: problem".
  InputError(const std::filesystem::path& file, const std::string& problem);
  /// what() is "file:line: problem"; `line` counts from 1.
  InputError(const std::filesystem::path& file, long line, const std::string& problem);
};

/// An option has an unknown name, or a value outside its range.
class OptionError : public Error {
 public:
  using Error::Error;
};

/// Valid data has no answer to a question, for example two trajectories without common stamps, or
/// an alignment of positions that lie on one line.
class DataError : public Error {
 public:
  using Error::Error;
};

/// A file cannot be written (permissions, full disk).
class OutputError : public Error {
 public:
  /// what() is "file: problem".
  OutputError(const std::filesystem::path& file, const std::string& problem);
};

/// A function was called at a time when it cannot work: on an object that was moved from, or on one
/// in which another thread is.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace cvo_slam
