// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A researcher who gets a plausible trajectory from the wrong camera publishes it.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/files.h"
#include "cvo_slam/io/camera_check.h"
#include "cvo_slam/io/camera_file.h"
#include "cvo_slam/io/dataset.h"
#include "cvo_slam/tests/io/tiny_sequence.h"
#include "cvo_slam/tests/test_data.h"

namespace cvo_slam {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnknownCamera = "the camera of this sequence is not known";

/// A sequence in a folder of this name, below a folder of its own.
class NamedFolder {
 public:
  explicit NamedFolder(const std::string& name) : path_(parent_.path() / name) {
    const TinySequence sequence;
    sequence.write_tum();
    fs::copy(sequence.path(), path_, fs::copy_options::recursive);
  }

  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] fs::path parent() const { return parent_.path(); }
  void write(const std::string& name, const std::string& text) const {
    parent_.write(path_.filename() / name, text);
  }
  [[nodiscard]] std::string problem() const {
    return input_error(path_, [&] { return open_dataset(path_); });
  }

 private:
  TemporaryFolder parent_;
  fs::path path_;
};

TEST(CameraChoice, TheNameOfTheFolderDoesNotDecide) {
  for (const char* name : {"livingroom1", "fr2_walk_home", "rgbd_dataset_freiburg1_rpy",
                           "living_room_traj2_frei_png", "office_kt1"}) {
    EXPECT_THAT(NamedFolder(name).problem(), testing::HasSubstr(kUnknownCamera)) << name;
  }
}

TEST(CameraChoice, ACommentThatNamesNoRecordingOfTumDoesNotDecide) {
  for (const char* name : {"fr1_walk.bag", "rgbd_dataset_freiburg4_x.bag", "freiburg1", ""}) {
    const NamedFolder folder("recording");
    folder.write("rgb.txt", fmt::format("# file: '{}'\n0.00 rgb/0.png\n", name));
    EXPECT_THAT(folder.problem(), testing::HasSubstr(kUnknownCamera)) << name;
  }
}

TEST(CameraChoice, TheOrderOfAListDoesNotDecide) {
  const NamedFolder folder("recording");
  folder.write("associations.txt", "1 depth/0.png 1 rgb/0.png\n2 depth/1.png 2 rgb/1.png\n");
  folder.write("groundtruth.txt", "1 0 0 0 0 0 0 1\n2 0.1 0 0 0 0 0 1\n");
  EXPECT_THAT(folder.problem(), testing::HasSubstr(kUnknownCamera));
}

TEST(CameraChoice, ACameraFileBesideTheImagesOrAboveIsTaken) {
  const NamedFolder folder("recording");
  write_camera(folder.parent() / "camera.yaml", tiny_camera());
  EXPECT_EQ(open_dataset(folder.path())->camera_origin(),
            "camera.yaml in the folder above the sequence");
  Camera nearer = tiny_camera();
  nearer.name = "nearer";
  write_camera(folder.path() / "rgb" / "camera.yaml", nearer);
  EXPECT_EQ(open_dataset(folder.path())->camera_origin(), "camera.yaml in the folder rgb");
  EXPECT_EQ(open_dataset(folder.path())->camera().name, "nearer");
}

TEST(CameraChoice, ASettingsFileOfOrbSlamIsTakenUnlessThereAreTwo) {
  const NamedFolder folder("recording");
  const std::string settings =
      "%YAML:1.0\nCamera.fx: 8.0\nCamera.fy: 8.0\nCamera.cx: 3.5\nCamera.cy: 2.5\n"
      "Camera.width: 8\nCamera.height: 6\nDepthMapFactor: 5000.0\n";
  folder.write("mine.yaml", settings);
  folder.write("options.yaml", "schedule: late\n");  // no camera
  EXPECT_EQ(open_dataset(folder.path())->camera_origin(),
            "mine.yaml in the folder of the sequence");
  folder.write("other.yaml", settings);
  EXPECT_THAT(folder.problem(), testing::HasSubstr("mine.yaml and other.yaml"));
}

TEST(CameraChoice, ACameraFileThatIsNotReadIsNamed) {
  const NamedFolder folder("recording");
  folder.write("calibration.txt", "525 525 319.5 239.5\n");
  EXPECT_THAT(folder.problem(),
              testing::HasSubstr("calibration.txt in the folder of the sequence is in a format"));
  folder.write("rgb.txt", "# file: 'rgbd_dataset_freiburg2_desk.bag'\n0.00 rgb/0.png\n");
  EXPECT_THAT(folder.problem(),
              testing::HasSubstr("it is not known whether the camera is tum_fr2"));
}

/// A folder with links to the first frames of 7-Scenes.
class FirstFramesOfSevenScenes {
 public:
  FirstFramesOfSevenScenes() {
    for (int i = 0; i < 20; ++i) {
      for (const char* kind : {"color.jpg", "depth.png", "pose.txt"}) {
        const std::string name = fmt::format("frame-{:06}.{}", i, kind);
        fs::create_symlink(fs::absolute(test_data() / "7scenes/seq-01" / name), path() / name);
      }
    }
  }

  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  void write(const std::string& name, const std::string& text) const { folder_.write(name, text); }

 private:
  TemporaryFolder folder_;
};

TEST(CameraChoice, TheImagesSingleOutThatOfSevenScenes) {
  CVO_SLAM_REQUIRE_DATA("7scenes/seq-01");
  const FirstFramesOfSevenScenes folder;
  const auto data = open_dataset(folder.path());
  EXPECT_EQ(data->camera().name, "7scenes");
  EXPECT_THAT(data->camera_origin(), testing::HasSubstr("re-project several times better"));
  folder.write("camera-intrinsics.txt", "585 0 320\n0 585 240\n0 0 1\n");
  EXPECT_EQ(open_dataset(folder.path())->camera().name, "7scenes");
  // A recording of others in the same layout.
  folder.write("camera-intrinsics.txt", "518 0 325\n0 519 253\n0 0 1\n");
  EXPECT_THAT(input_error(folder.path(), [&] { return open_dataset(folder.path()); }),
              testing::HasSubstr("it is not known whether the camera is 7scenes"));
}

TEST(CameraChoice, TheImagesSingleOutThatOfIclNuim) {
  CVO_SLAM_REQUIRE_DATA("fixtures/icl_nuim");
  const auto data = open_dataset(test_data() / "fixtures/icl_nuim");
  EXPECT_EQ(data->camera().name, "icl_nuim");
  EXPECT_THAT(data->camera_origin(), testing::HasSubstr("re-project several times better"));
}

TEST(CameraChoice, ImagesOfOneOfTheKinectsOfTumAreNotToldApart) {
  CVO_SLAM_REQUIRE_DATA("tum/rgbd_dataset_freiburg1_rpy");
  const fs::path rpy = fs::absolute(test_data() / "tum/rgbd_dataset_freiburg1_rpy");
  const TemporaryFolder folder;
  for (const char* name : {"rgb", "depth", "depth.txt", "groundtruth.txt"}) {
    fs::create_symlink(rpy / name, folder.path() / name);
  }
  std::string list = read_file(rpy / "rgb.txt");
  folder.write("rgb.txt", list.substr(list.find("\n1") + 1));  // without its comments
  EXPECT_THAT(input_error(folder.path(), [&] { return open_dataset(folder.path()); }),
              testing::HasSubstr(kUnknownCamera));
}

TEST(CameraWarnings, AreQuietForTheBuiltInCameras) {
  for (const std::string& name : builtin_camera_names()) {
    EXPECT_THAT(camera_warnings(builtin_camera(name)), testing::IsEmpty()) << name;
  }
}

TEST(CameraWarnings, TellWhatIsUnlikely) {
  Camera camera = builtin_camera("tum_fr3");
  camera.color.width = 320;  // the camera of images of twice the size
  camera.color.height = 240;
  EXPECT_THAT(camera_warnings(camera),
              testing::Contains(testing::HasSubstr("far from the centre of its 320x240 pixels")));
  camera = builtin_camera("tum_fr3");
  camera.color.distortion = {-0.9, 0, 0, 0, 0};
  EXPECT_THAT(camera_warnings(camera),
              testing::Contains(testing::HasSubstr("folds back inside the image")));
  camera = builtin_camera("tum_fr3");
  camera.color.fx = 5354;
  EXPECT_THAT(camera_warnings(camera), testing::Contains(testing::HasSubstr("focal length 5354")));
}

TEST(Reprojection, TellsAWrongCamera) {
  CVO_SLAM_REQUIRE_DATA("tum/rgbd_dataset_freiburg1_rpy");
  const auto folder = test_data() / "tum/rgbd_dataset_freiburg1_rpy";
  const auto warning_with = [&](Camera camera) {
    const auto data = open_dataset(folder, {.camera = std::move(camera)});
    return reprojection_warning(measure_reprojection(*data, data->reference()).value(), "truth");
  };
  EXPECT_EQ(warning_with(builtin_camera("tum_fr1")), std::nullopt);
  // The camera turns on the spot, which does not show a wrong depth scale: fy < 0 is shown.
  EXPECT_NE(warning_with(builtin_camera("icl_nuim")), std::nullopt);
}

}  // namespace
}  // namespace cvo_slam
