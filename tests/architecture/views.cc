// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>

#include "cvo_slam/tests/architecture/source_file.h"

namespace cvo_slam::architecture {
namespace {

std::string blank_copy(std::string_view text) {
  std::string blank(text);
  for (char& c : blank) {
    if (c != '\n') c = ' ';
  }
  return blank;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Walks over a text once and deals its characters out to the views.
class Splitter {
 public:
  explicit Splitter(std::string_view text)
      : text_(text), views_{blank_copy(text), blank_copy(text), blank_copy(text)} {}

  Views split_cpp() {
    while (position_ < text_.size()) {
      if (starts_with("//")) {
        copy_to(views_.comments, text_.find('\n', position_));
      } else if (starts_with("/*")) {
        copy_to(views_.comments, end_of("*/", position_ + 2));
      } else if (text_[position_] == '"' && is_raw_string()) {
        copy_to(views_.strings, end_of_raw_string());
      } else if (text_[position_] == '"') {
        copy_to(views_.strings, end_of_literal('"'));
      } else if (text_[position_] == '\'' && !follows_word()) {
        copy_to(views_.strings, end_of_literal('\''));
      } else {
        copy_to(views_.code, position_ + 1);
      }
    }
    return views_;
  }

  Views split_script() {
    while (position_ < text_.size()) {
      if (text_[position_] == '#' && !follows_nonblank()) {
        copy_to(views_.comments, text_.find('\n', position_));
      } else if (text_[position_] == '"') {
        copy_to(views_.code, end_of_literal('"'));
      } else {
        copy_to(views_.code, position_ + 1);
      }
    }
    return views_;
  }

 private:
  [[nodiscard]] bool starts_with(std::string_view word) const {
    return text_.substr(position_).starts_with(word);
  }
  /// A quote behind a digit separates digits (1'000); u8'a' and its kind are not in use here.
  [[nodiscard]] bool follows_word() const { return position_ > 0 && is_word(text_[position_ - 1]); }
  [[nodiscard]] bool follows_nonblank() const {
    return position_ > 0 && std::isspace(static_cast<unsigned char>(text_[position_ - 1])) == 0;
  }
  [[nodiscard]] bool is_raw_string() const { return position_ > 0 && text_[position_ - 1] == 'R'; }

  [[nodiscard]] std::size_t end_of(std::string_view word, std::size_t from) const {
    const std::size_t found = text_.find(word, from);
    return found == std::string_view::npos ? found : found + word.size();
  }

  [[nodiscard]] std::size_t end_of_raw_string() const {
    const std::size_t open = text_.find('(', position_);
    if (open == std::string_view::npos) return open;
    const std::string delimiter(text_.substr(position_ + 1, open - position_ - 1));
    return end_of(")" + delimiter + "\"", open);
  }

  [[nodiscard]] std::size_t end_of_literal(char quote) const {
    for (std::size_t i = position_ + 1; i < text_.size(); ++i) {
      if (text_[i] == '\\')
        ++i;
      else if (text_[i] == quote)
        return i + 1;
    }
    return text_.size();
  }

  void copy_to(std::string& view, std::size_t end) {
    end = std::min(end, text_.size());
    for (; position_ < end; ++position_) view[position_] = text_[position_];
  }

  std::string_view text_;
  std::size_t position_ = 0;
  Views views_;
};

}  // namespace

Views split_views(std::string_view text, Language language) {
  Splitter splitter(text);
  return language == Language::kCpp ? splitter.split_cpp() : splitter.split_script();
}

}  // namespace cvo_slam::architecture
