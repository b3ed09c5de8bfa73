// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/trajectory_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::HasSubstr;

class TrajectoryFiles : public testing::Test {
 protected:
  std::vector<StampedPose> read(const std::string& text) {
    return read_tum(folder_.write("poses.txt", text));
  }

  void expect_error(const std::string& text, const std::string& message) {
    try {
      read(text);
      FAIL() << "no error for " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("poses.txt:" + message));
    }
  }

  TemporaryFolder folder_;
};

TEST_F(TrajectoryFiles, RoundTripKeepsEveryDigit) {
  const std::string text =
      "# stamp tx ty tz qx qy qz qw (T_world_camera)\n"
      "1305031102.1604 1.344379000 -0.627206000 1.661754123 0.000000000 0.000000000 0.600000000 "
      "0.800000000\n"
      "1305031103 0.000000001 0.000000000 0.000000000 1.000000000 0.000000000 0.000000000 "
      "0.000000000\n";
  const auto file = folder_.path() / "again.txt";
  write_tum(file, {read(text), {}});
  EXPECT_EQ(read_text(file), text);
}

TEST_F(TrajectoryFiles, LostFramesAreCommentsInTheirPlace) {
  const SE3 pose;
  const Trajectory trajectory{{{Timestamp(2000000000, 1), pose}, {Timestamp(4000000000, 1), pose}},
                              {{Timestamp(1000000000, 1), "no depth"},
                               {Timestamp(3000000000, 1), "blur"},
                               {Timestamp(5000000000, 1), "end"}}};
  const auto file = folder_.path() / "lost.txt";
  write_tum(file, trajectory);
  const std::string identity =
      " 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 1.000000000\n";
  EXPECT_EQ(read_text(file),
            "# stamp tx ty tz qx qy qz qw (T_world_camera)\n# lost 1.0 no depth\n2.0" + identity +
                "# lost 3.0 blur\n4.0" + identity + "# lost 5.0 end\n");
  EXPECT_EQ(read_tum(file).size(), 2U);
}

TEST_F(TrajectoryFiles, NormalisesTheQuaternion) {
  const auto poses = read("1 0 0 0 0 0 0 2\n");
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_TRUE(poses[0].T_world_camera.rotation().isIdentity(1e-15));
}

TEST_F(TrajectoryFiles, SkipsCommentsBlankLinesAndForeignLineEnds) {
  EXPECT_EQ(read("# c\n\n  \n1 0 0 0 0 0 0 1\r\n\t2 0 0 0 0 0 0 1").size(), 2U);
}

TEST_F(TrajectoryFiles, TheFirstOfRepeatedStampsIsKept) {
  const auto poses = read("1 5 0 0 0 0 0 1\n1 6 0 0 0 0 0 1\n2 7 0 0 0 0 0 1\n");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].T_world_camera.translation().x(), 5);
}

TEST_F(TrajectoryFiles, EachErrorNamesItsLine) {
  expect_error("# c\n1 0 0 0 0 0 0\n", "2: expected 8 values");
  expect_error("1 0 0 0 0 0 0 1 9\n", "1: expected 8 values");
  expect_error("1 0 0 0 0 0 0 1\nx 0 0 0 0 0 0 1\n", "2: 'x' is not a time stamp");
  expect_error("1 0 nan 0 0 0 0 1\n", "1: 'nan' is not a finite number");
  expect_error("1 0 0 inf 0 0 0 1\n", "1: 'inf' is not a finite number");
  expect_error("1 0 0 0x 0 0 0 1\n", "1: '0x' is not a finite number");
  expect_error("1 0 0 0 0 0 0 0\n", "1: the quaternion has length zero");
  expect_error("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n", "2: stamp 1 is before the one above");
}

// "27 of 27 matched" was said of a file of 788 lines whose stamps were rounded to seconds.
TEST_F(TrajectoryFiles, OfForeignFilesWhatIsLeftOutIsCounted) {
  const auto trajectory = read_foreign_tum(folder_.write(
      "poses.txt",
      "3 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n1 3 0 0 0 0 0 1\n"
      "4 nan nan nan nan nan nan nan\nnan 0 0 0 0 0 0 1\n5 0 0 0 0 0 0 0\n6 0 -inf 0 0 0 0 1\n"
      "7 1e200 0 0 0 0 0 1\n"));
  ASSERT_EQ(trajectory.poses.size(), 2U);
  EXPECT_EQ(trajectory.poses[0].T_world_camera.translation().x(), 1);
  EXPECT_EQ(trajectory.left_out.repeated, 2U);
  EXPECT_EQ(trajectory.left_out.invalid, 5U);
  EXPECT_EQ(trajectory.left_out.total(), 7U);
  EXPECT_THAT(
      trajectory.notes,
      testing::ElementsAre(
          "poses.txt: stamps out of order; sorted",
          "poses.txt: 2 duplicated stamps in 9 lines; the later ones are left out",
          HasSubstr("poses.txt: 5 of 9 lines have no valid pose (values that are not finite")));
  std::vector<std::string> notes = {"before"};
  EXPECT_EQ(read_tum_in_any_order(folder_.path() / "poses.txt", notes).size(), 2U);
  EXPECT_EQ(notes.size(), 4U);
}

TEST_F(TrajectoryFiles, LinesThatAreNoNumbersAreErrorsOfForeignFilesToo) {
  for (const char* text : {"1 0 0 0 0 0 0 one\n", "1 0 0 0 0 0 1\n", "x 0 0 0 0 0 0 1\n"}) {
    EXPECT_THROW(static_cast<void>(read_foreign_tum(folder_.write("p.txt", text))), InputError);
  }
}

TEST_F(TrajectoryFiles, ReadsCsvWithoutAHeading) {
  const auto poses = read("1.5, 1, 2, 3, 0, 0, 0, 1\n2.5,+4,5,1e-400,0,0,0,1\r\n3;0;0;0;0;0;0;1\n");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[0].T_world_camera.translation(), Vector3(1, 2, 3));
  EXPECT_EQ(poses[1].T_world_camera.translation(), Vector3(4, 5, 0));
  EXPECT_EQ(poses[1].stamp.to_string(), "2.5");
  expect_error("1,0,0,0,0,0,0\n", "1: expected 8 values 'stamp tx ty tz qx qy qz qw', found 7");
  expect_error("stamp,tx,ty,tz,qx,qy,qz,qw\n", "1: 'stamp' is not a time stamp");
  expect_error("1 0,5 0 0 0 0 0 1\n", "1: '0,5' has a decimal comma");
  expect_error("1;0,5;0;0;0;0;0;1\n", "1: '0,5' has a decimal comma");
  expect_error("1305031102175.3 0 0 0 0 0 0 1\n", "1: '1305031102175.3' is a time in milli");
}

TEST_F(TrajectoryFiles, MissingFileAndFullDiskAreErrors) {
  EXPECT_THROW(static_cast<void>(read_tum(folder_.path() / "missing.txt")), InputError);
  EXPECT_THROW(write_tum(folder_.path() / "no" / "folder.txt", {}), OutputError);
  EXPECT_THROW(write_tum("/dev/full", {}), OutputError);
}

}  // namespace
}  // namespace cvo_slam
