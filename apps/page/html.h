// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of HTML that a report needs. Functions escape their text, but not their `content`,
// which is HTML already.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam::html {

/// Returns text that may stand between tags and in quoted attributes. Control characters except the
/// new line, and bytes that are not UTF-8, become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// Returns <tag attributes>content</tag>.
[[nodiscard]] std::string element(std::string_view tag, std::string_view content,
                                  std::string_view attributes = "");
[[nodiscard]] std::string paragraph(std::string_view text);
/// Returns a section with a title; a link "#id" leads to it.
[[nodiscard]] std::string section(std::string_view id, std::string_view title,
                                  std::string_view content);
/// Returns content with a line of text below it.
[[nodiscard]] std::string figure(std::string_view content, std::string_view caption);

/// Returns a file as part of the page (RFC 2397).
[[nodiscard]] std::string data_uri(std::string_view media_type, std::string_view bytes);
/// Returns a JPEG file as part of the page; `alternative` describes it in words.
[[nodiscard]] std::string jpeg_image(std::string_view bytes, std::string_view alternative);
/// Encodes an image (CV_8UC3) as JPEG first.
[[nodiscard]] std::string jpeg_image(const cv::Mat& image, std::string_view alternative);

enum class Cell { kText, kNumber, kCode };

struct Column {
  std::string title;
  Cell kind = Cell::kText;
};

/// A table of texts.
class Table {
 public:
  explicit Table(std::vector<Column> columns);

  /// Adds a row; it must have as many cells as there are columns.
  Table& add(const std::vector<std::string>& cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string content() const;

 private:
  std::vector<Column> columns_;
  std::string rows_;
};

}  // namespace cvo_slam::html
