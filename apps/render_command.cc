// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cvo_slam/apps/command.h"
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

/// Throws OptionError where the text is not "<width>x<height>".
void parse_size(const std::string& text, render::ViewOptions& view) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &view.width, &view.height, &rest) != 2) {
    throw OptionError(fmt::format("--size {} must be <width>x<height>, e.g. 1920x1080", text));
  }
}

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

/// As the user says; nothing where that is "auto".
void apply_up(const std::string& name, render::MapScene& scene) {
  for (const auto& [direction, up] : up_directions()) {
    if (direction == name) scene.up = up;
  }
}

/// A single trajectory is coloured by time; of several, each has its own colour.
void choose_colors(PathColor color, render::MapScene& scene) {
  if (color != PathColor::kTime || scene.paths.size() != 1) return;
  render::Path path = std::move(scene.paths[0]);
  scene.paths.clear();
  render::add_path_by_time(scene, std::move(path.label), std::move(path.poses));
}

render::MapScene load_scene(const RenderArguments& arguments) {
  render::MapScene scene;
  for (const auto& input : arguments.inputs) add_to_scene(scene, input);
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
    std::vector<std::string> notes;
    add_reference(scene, read_tum_in_any_order(arguments.reference, notes), arguments.color);
  } else if (arguments.color == PathColor::kError) {
    throw OptionError("--color error needs the true trajectory: name it with --reference");
  }
  apply_up(arguments.up, scene);
  scene.title = arguments.title;
  scene.point_size = arguments.point_size;
  return scene;
}

/// "out.png" of frame 7 is "out_0007.png".
std::filesystem::path numbered(const std::filesystem::path& file, int frame) {
  return file.parent_path() /
         fmt::format("{}_{:04}{}", file.stem().string(), frame, file.extension().string());
}

/// The options of one frame of a tour: once around, or along the path.
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
  parse_size(arguments.size, arguments.view);
  arguments.view.azimuth = arguments.azimuth * std::numbers::pi / 180;
  constexpr int kFramesOfAVideo = 120;
  if (!arguments.video.empty() && arguments.frames == 0) arguments.frames = kFramesOfAVideo;
  if (arguments.out.empty() && arguments.video.empty()) {
    throw OptionError("say where to write the picture: -o out.png, or --video out.avi");
  }
  const render::MapScene scene = load_scene(arguments);
  const auto renderer = render::make_renderer(arguments.renderer);
  for (const auto& note : render::scene_notes(scene)) fmt::print(stderr, "note: {}\n", note);
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

template <typename E>
auto choice(std::vector<std::pair<std::string, E>> names) {
  return CLI::CheckedTransformer(std::move(names)).description("");
}

void add_options(CLI::App& command, RenderArguments& arguments) {
  command
      .add_option("inputs", arguments.inputs,
                  "Folder of a run, trajectories (TUM format), a .g2o or a .ply file; several are "
                  "drawn together")
      ->required();
  command.add_option("-o,--out", arguments.out, "The picture: .png or .jpg");
  command
      .add_option("--view", arguments.view.kind,
                  "top, front, side (orthographic), iso, turntable or follow (default iso)")
      ->transform(choice(render::view_names()));
  command.add_option("--size", arguments.size, "<width>x<height> [px], up to 4096")
      ->capture_default_str();
  command.add_option("--azimuth", arguments.azimuth,
                     "Of the view turntable: turned about up by so much [deg]");
  command
      .add_option("--at", arguments.view.progress,
                  "Of the view follow: where on the trajectory, 0 to 1 (default 1)")
      ->check(CLI::Range(0.0, 1.0));
  command
      .add_option("--turntable", arguments.frames,
                  "So many pictures once around, out_0000.png and on; with --view follow along the "
                  "trajectory")
      ->check(CLI::Range(1, 10000));
  command.add_option(
      "--video", arguments.video,
      "The same as a film, Motion JPEG in a .avi file, 25 pictures a second (default "
      "120 pictures)");
  command.add_option("--reference", arguments.reference,
                     "The true trajectory, drawn too; its z is up");
  command
      .add_option("--color", arguments.color,
                  "time, error (needs --reference) or plain: of the trajectory (default time)")
      ->transform(choice<PathColor>({{"time", PathColor::kTime},
                                     {"error", PathColor::kError},
                                     {"plain", PathColor::kPlain}}));
  command.add_option("--up", arguments.up, "auto, x, y, z, -x, -y or -z: where up is in the world")
      ->check(CLI::IsMember({"auto", "x", "y", "z", "-x", "-y", "-z"}))
      ->capture_default_str();
  command
      .add_option("--backend", arguments.renderer,
                  "auto, osmesa, egl or splat; auto = osmesa, or splat where that does not work "
                  "(default auto)")
      ->transform(choice(render::renderer_names()));
  command
      .add_option("--point-size", arguments.point_size,
                  "Diameter of the map's points [m] (default: by their density)")
      ->check(CLI::Range(0.0, 100.0));
  command.add_option("--title", arguments.title, "Written on the picture");
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command =
      app.add_subcommand("render", "Draw a map, trajectories or a graph, without a display");
  add_options(*command, *arguments);
  command->callback(
      [&action, arguments] { action = [arguments] { return run_render(*arguments); }; });
}

}  // namespace cvo_slam
