// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/argument_text.h"
#include "cvo_slam/apps/command_line.h"
#include "cvo_slam/apps/scene_files.h"
#include "cvo_slam/core/error.h"
#include "cvo_slam/io/trajectory_files.h"
#include "cvo_slam/render/motion_jpeg.h"
#include "cvo_slam/render/picture.h"

namespace cvo_slam {
namespace {

struct RenderArguments {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path out;
  std::filesystem::path reference;
  std::filesystem::path video;
  std::string size = "1920x1080";
  std::string up = "auto";
  std::string title;
  PathColor color = PathColor::kTime;
  render::RendererKind renderer = render::RendererKind::kAuto;
  render::ViewOptions view;
  double azimuth = 0;     // [deg]
  double point_size = 0;  // [m]
  int frames = 0;
};

const std::vector<std::pair<std::string, Vector3>>& up_directions() {
  static const std::vector<std::pair<std::string, Vector3>> directions = {
      {"x", Vector3::UnitX()},   {"y", Vector3::UnitY()},   {"z", Vector3::UnitZ()},
      {"-x", -Vector3::UnitX()}, {"-y", -Vector3::UnitY()}, {"-z", -Vector3::UnitZ()}};
  return directions;
}

Vector3 estimate_up(const render::MapScene& scene) {
  std::vector<SE3> cameras = scene.keyframes;
  for (const auto& path : scene.paths) {
    for (const auto& pose : path.poses) cameras.push_back(pose.T_world_camera);
  }
  return render::estimate_up(cameras, scene.points);
}

/// Sets the up direction that the user names; "auto" leaves the estimated one.
void apply_up(const std::string& name, render::MapScene& scene) {
  for (const auto& [direction, up] : up_directions()) {
    if (direction == name) scene.up = up;
  }
}

/// Colours a single trajectory by time; several trajectories keep a colour each.
void choose_colors(PathColor color, render::MapScene& scene) {
  if (color != PathColor::kTime || scene.paths.size() != 1) return;
  render::Path path = std::move(scene.paths[0]);
  scene.paths.clear();
  render::add_path_by_time(scene, std::move(path.label), std::move(path.poses));
}

/// Returns the scene that the arguments ask for; adds what was not understood to `notes`.
render::MapScene load_scene(const RenderArguments& arguments, std::vector<std::string>& notes) {
  render::MapScene scene;
  for (const auto& input : arguments.inputs) add_to_scene(scene, input, notes);
  const bool empty = scene.points.empty() && scene.keyframes.empty() &&
                     std::all_of(scene.paths.begin(), scene.paths.end(),
                                 [](const render::Path& path) { return path.poses.empty(); });
  if (empty) {
    throw InputError(arguments.inputs.front(),
                     "nothing to draw: no point and no pose; name a run, a trajectory, a .g2o or a "
                     ".ply file that has some");
  }
  scene.up = estimate_up(scene);
  choose_colors(arguments.color, scene);
  if (!arguments.reference.empty()) {
    add_reference(scene, read_tum_in_any_order(arguments.reference, notes), arguments.color);
  } else if (arguments.color == PathColor::kError) {
    throw OptionError("--color error needs the true trajectory: name it with --reference");
  }
  apply_up(arguments.up, scene);
  scene.title = arguments.title;
  scene.point_size = arguments.point_size;
  return scene;
}

/// Returns "out_0007.png" for frame 7 of "out.png".
std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
  return file.parent_path() /
         fmt::format("{}_{:04}{}", file.stem().string(), frame, file.extension().string());
}

/// Returns the view of one frame of a tour, which goes once around or along the path.
render::ViewOptions view_of_frame(const RenderArguments& arguments, int frame) {
  render::ViewOptions view = arguments.view;
  const double share = static_cast<double>(frame) / arguments.frames;
  if (view.kind == render::ViewKind::kFollow) {
    view.progress = share;
  } else {
    view.kind = render::ViewKind::kTurntable;
    view.azimuth += 2 * std::numbers::pi * share;
  }
  return view;
}

void draw_tour(const RenderArguments& arguments, const render::MapScene& scene,
               render::Renderer& renderer) {
  render::MotionJpeg video;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    const auto picture = render::draw_picture(scene, view_of_frame(arguments, frame), renderer);
    if (!arguments.out.empty())
      render::write_picture(numbered(arguments.out, frame), picture.image);
    if (!arguments.video.empty()) video.add(picture.image);
  }
  if (!arguments.out.empty()) {
    fmt::print("{} to {}\n", numbered(arguments.out, 0).string(),
               numbered(arguments.out, arguments.frames - 1).string());
  }
  if (arguments.video.empty()) return;
  video.write(arguments.video);
  fmt::print("{}\n", arguments.video.string());
}

int run_render(RenderArguments arguments) {
  const PixelSize size = parse_size(arguments.size, "1920x1080");
  arguments.view.width = size.width;
  arguments.view.height = size.height;
  arguments.view.azimuth = arguments.azimuth * std::numbers::pi / 180;
  constexpr int kFramesOfAVideo = 120;
  if (!arguments.video.empty() && arguments.frames == 0) arguments.frames = kFramesOfAVideo;
  if (arguments.out.empty() && arguments.video.empty()) {
    throw OptionError("say where to write the picture: -o out.png, or --video out.avi");
  }
  std::vector<std::string> notes;
  const render::MapScene scene = load_scene(arguments, notes);
  const auto renderer = render::make_renderer(arguments.renderer);
  for (std::string& note : render::scene_notes(scene)) notes.push_back(std::move(note));
  for (const auto& note : notes) fmt::print(stderr, "note: {}\n", note);
  if (arguments.frames > 0) {
    draw_tour(arguments, scene, *renderer);
    return kDone;
  }
  const auto picture = render::draw_picture(scene, arguments.view, *renderer);
  render::write_picture(arguments.out, picture.image);
  fmt::print("{}: {} points, {} keyframes, drawn by {}\n", arguments.out.string(),
             scene.points.size(), scene.keyframes.size(), renderer->name());
  return kDone;
}

void add_view_options(Command& command, RenderArguments& arguments) {
  command.add_choice("--view", &arguments.view.kind, render::view_names(),
                     "top, front, side (orthographic), iso, turntable or follow (default iso)");
  command.add("--size", &arguments.size, "Size of the picture, <width>x<height> [px], up to 4096")
      .show_default();
  command.add("--azimuth", &arguments.azimuth,
              "Angle of the view turntable about the up direction [deg] (default 0)");
  command
      .add("--at", &arguments.view.progress,
           "Position of the view follow on the trajectory, 0 to 1 (default 1)")
      .in_range(0.0, 1.0);
  command
      .add("--turntable", &arguments.frames,
           "Draw n pictures once around, out_0000.png and so on; with --view follow along the "
           "trajectory")
      .in_range(1, 10000);
  command.add(
      "--video", &arguments.video,
      "Write the same pictures as a video, Motion JPEG in a .avi file, 25 pictures a second "
      "(default 120 pictures)");
}

void add_options(Command& command, RenderArguments& arguments) {
  command
      .add("inputs", &arguments.inputs,
           "Folder of a run, trajectories (TUM format), g2o or PLY files; several are drawn "
           "together")
      .required();
  command.add("-o,--out", &arguments.out, "The picture to write: .png or .jpg");
  add_view_options(command, arguments);
  command.add("--reference", &arguments.reference,
              "The true trajectory, to be drawn too; its z axis is taken for up");
  command.add_choice<PathColor, PathColor>(
      "--color", &arguments.color,
      {{"time", PathColor::kTime}, {"error", PathColor::kError}, {"plain", PathColor::kPlain}},
      "time, error (needs --reference) or plain: the colours of the trajectory (default time)");
  command.add("--up", &arguments.up, "Up direction of the world: auto, x, y, z, -x, -y or -z")
      .one_of({"auto", "x", "y", "z", "-x", "-y", "-z"})
      .show_default();
  command.add_choice("--backend", &arguments.renderer, render::renderer_names(),
                     "auto, osmesa, egl or splat: the renderer; auto = osmesa, or splat if that "
                     "does not work (default auto)");
  command
      .add("--point-size", &arguments.point_size,
           "Diameter of the points of the map [m] (default: from their density)")
      .in_range(0.0, 100.0);
  command.add("--title", &arguments.title, "Text to write on the picture");
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<RenderArguments>();
  Command command(app, "render", "Draw a map, trajectories or a graph, without a display");
  add_options(command, *arguments);
  command.on_parsed(action, [arguments] { return run_render(*arguments); });
}

}  // namespace cvo_slam
