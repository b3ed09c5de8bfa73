// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/html.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>

#include "cvo_slam/core/error.h"
#include "cvo_slam/plot/base64.h"

namespace cvo_slam::html {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0;
}

/// Returns the number of bytes of the character that begins here, or 0 if none does. RFC 3629: no
/// more bytes than needed, no surrogates, nothing above U+10FFFF.
std::size_t utf8_length(std::string_view text) {
  const std::uint8_t first = byte_at(text, 0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, i) & 0xC0) != 0x80) return 0;
  }
  const std::uint8_t second = byte_at(text, 1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return length;
}

std::string_view escaped_ascii(const char& c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7F
                 ? kReplacement
                 : std::string_view(&c, 1);
  }
}

std::string_view class_of(Cell kind) {
  switch (kind) {
    case Cell::kText:
      return "";
    case Cell::kNumber:
      return R"( class="number")";
    case Cell::kCode:
      return R"( class="code")";
  }
  return "";
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 1) {
      result += escaped_ascii(text.front());
    } else {
      result += length == 0 ? kReplacement : text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

std::string element(std::string_view tag, std::string_view content, std::string_view attributes) {
  return fmt::format("<{0}{1}{2}>{3}</{0}>\n", tag, attributes.empty() ? "" : " ", attributes,
                     content);
}

std::string paragraph(std::string_view text) { return element("p", escaped(text)); }

std::string section(std::string_view id, std::string_view title, std::string_view content) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", escaped(id),
                     escaped(title), content);
}

std::string figure(std::string_view content, std::string_view caption) {
  return fmt::format(
      "<figure>\n<div class=\"frame\">{}</div>\n<figcaption>{}</figcaption>\n</figure>\n", content,
      escaped(caption));
}

std::string data_uri(std::string_view media_type, std::string_view bytes) {
  return fmt::format("data:{};base64,{}", media_type, to_base64(bytes));
}

std::string jpeg_image(std::string_view bytes, std::string_view alternative) {
  return fmt::format("<img alt=\"{}\" src=\"{}\">", escaped(alternative),
                     data_uri("image/jpeg", bytes));
}

std::string jpeg_image(const cv::Mat& image, std::string_view alternative) {
  constexpr int kQuality = 88;
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, kQuality})) {
    throw Error("OpenCV cannot encode JPEG");
  }
  return jpeg_image(std::string(bytes.begin(), bytes.end()), alternative);
}

Table::Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

Table& Table::add(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    rows_ += fmt::format("<td{}>{}</td>", class_of(columns_.at(i).kind), escaped(cells[i]));
  }
  rows_ += "</tr>\n";
  return *this;
}

std::string Table::content() const {
  std::string head;
  for (const Column& column : columns_) {
    head +=
        fmt::format("<th scope=\"col\"{}>{}</th>", class_of(column.kind), escaped(column.title));
  }
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table></div>\n",
      head, rows_);
}

}  // namespace cvo_slam::html
