// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/apps/page/html.h"

#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <utf8.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/plot/image_data.h"

namespace cvo_slam::html {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Returns what stands for one byte of valid UTF-8.
std::string_view escaped_byte(const char& c) {
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
  const auto* position = text.begin();
  while (true) {
    const auto* invalid = utf8::find_invalid(position, text.end());
    for (; position != invalid; ++position) result += escaped_byte(*position);
    if (position == text.end()) return result;
    result += kReplacement;
    ++position;
  }
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
  return fmt::format(R"(<img alt="{}" src="{}">)", escaped(alternative),
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
