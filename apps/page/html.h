// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The little of HTML that a report needs. Functions that take text escape it; those that take
// `content` do not, because it is HTML.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace cvo_slam::html {

/// Text as it may stand between tags and in quoted attributes. Control characters but the new line,
/// and bytes that are not UTF-8, become U+FFFD.
[[nodiscard]] std::string escaped(std::string_view text);

/// <tag attributes>content</tag>.
[[nodiscard]] std::string element(std::string_view tag, std::string_view content,
                                  std::string_view attributes = "");
[[nodiscard]] std::string paragraph(std::string_view text);
/// With a title that a link "#id" leads to.
[[nodiscard]] std::string section(std::string_view id, std::string_view title,
                                  std::string_view content);
/// Content with a line of text below it.
[[nodiscard]] std::string figure(std::string_view content, std::string_view caption);

/// A file as part of the page (RFC 2397).
[[nodiscard]] std::string data_uri(std::string_view media_type, std::string_view bytes);
/// A JPEG as part of the page; `alternative` is what it shows, in words.
[[nodiscard]] std::string jpeg_image(std::string_view bytes, std::string_view alternative);
/// The same of an image, CV_8UC3.
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

  /// As many cells as columns.
  Table& add(const std::vector<std::string>& cells);
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string content() const;

 private:
  std::vector<Column> columns_;
  std::string rows_;
};

}  // namespace cvo_slam::html
