// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/io/dataset/formats_internal.h"
#include "cvo_slam/tests/io/tiny_sequence.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

TEST(DatasetFormats, AreListedForPeople) {
  std::set<std::string_view> names;
  for (const DatasetFormat* format : all_dataset_formats()) {
    EXPECT_TRUE(names.insert(format->name).second) << format->name << " is in the table twice";
    EXPECT_THAT(dataset_formats(),
                HasSubstr(std::string(format->name) + " (" + std::string(format->layout) + ")"));
  }
  EXPECT_GE(names.size(), 2U);
}

TEST(DatasetFormats, NoneRecognisesAnotherFolder) {
  const TinySequence sequence;
  sequence.write("images.txt", "0 rgb/0.png\n");
  sequence.write_color("rgb/0.png");
  for (const DatasetFormat* format : all_dataset_formats()) {
    EXPECT_FALSE(format->recognise(sequence.path())) << format->name;
  }
}

}  // namespace
}  // namespace cvo_slam
