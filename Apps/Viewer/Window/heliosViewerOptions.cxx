// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosViewerOptions.h"

#include "heliosCameraRig.h"
#include "heliosColorNames.h"
#include "heliosStatus.h"
#include "heliosTheme.h"
#include "vtkHeliosMemoryLimit.h"
#include "vtkHeliosVersion.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <iostream>
#include <regex>

namespace helios::viewer
{

namespace
{

const char* const Epilog = R"(what can be shown:
  a survey (XML)          runs while its cloud grows; nothing is written
  a run                   its folder, with run_summary.json: replayed
  clouds                  .xyz .las .laz .copc.laz .vtp .pvtp .ply .pcd .e57, one or several
  a scene                 XML, .obj, .tif, .stl, .gltf, .glb, .json (CityJSON), .ply with faces

keys and mouse: press h in the window.

without a display: with --offscreen, vtkhelios view starts one itself (Xvfb).

examples:
  vtkhelios view survey.xml
  vtkhelios view survey.xml --speed 1 --camera follow      in real time, with the platform
  vtkhelios view output/my_survey                          replay of a finished run
  vtkhelios view leg000_points.xyz --color-by amplitude
  vtkhelios view survey.xml --offscreen --record out.ogv --seconds 10 --camera follow
  vtkhelios view survey.xml --offscreen --still cloud.png --size 3840x2160
  vtkhelios view yard.las --html yard.html                 a web page; its options: --html --help

exit codes: 0 done, 1 failed (the reason is on standard error), 2 wrong usage
)";

void AddInputs(CLI::App& app, ViewerOptions& options)
{
  app.add_option("inputs", options.Inputs, "a survey, a run, clouds, or a scene")
    ->required()
    ->option_text("SURVEY.xml|RUN|CLOUD...|SCENE");
  app
    .add_option("--assets", options.Assets,
      "a folder to look up scenes, scanners and platforms in; may be repeated")
    ->option_text("DIR")
    ->allow_extra_args(false);
  app
    .add_option("--plugin", options.Plugins,
      "a shared library (.so) that registers echo detectors; may be repeated")
    ->option_text("FILE")
    ->allow_extra_args(false);
  app.add_option("--seed", options.Seed, "seed of the random numbers (default: the survey's)")
    ->check(CLI::Range(0LL, 4611686018427387904LL))
    ->option_text("N");
  app
    .add_option_function<std::uint64_t>(
      "--memory",
      [](const std::uint64_t& bytes)
      { vtkHeliosMemoryLimit::SetLimit(static_cast<double>(bytes) / 1048576.0); },
      "memory limit, e.g. 8G (default: the available memory)")
    ->transform(CLI::AsSizeValue(true))
    ->option_text("SIZE");
  app.add_flag(
    "!--no-noise", options.Noise, "no noise of ranges, directions, detector, platform and legs");
}

void AddTime(CLI::App& app, ViewerOptions& options, std::string& speed)
{
  app
    .add_option("--speed", speed,
      "seconds of the survey per second: 0.01 to 1000, 1 is real time; max: as fast as computed "
      "(default: max; for a recording: the whole survey)")
    ->option_text("X");
  app.add_option("--time", options.StartTime, "the time to start at [s]")
    ->check(CLI::NonNegativeNumber)
    ->option_text("S");
  app.add_flag("--paused", options.Paused, "start paused");
}

void AddLook(CLI::App& app, ViewerOptions& options, std::string& size)
{
  app.add_option("--camera", options.Camera, "the camera mode (default: free)")
    ->check(CLI::IsMember({ "free", "fly", "follow", "scanner", "top", "side", "orbit" }));
  app
    .add_option("--camera-script", options.CameraScript,
      "key frames: JSON, a list of {\"time\", \"position\", \"focalPoint\", \"viewUp\"}")
    ->option_text("FILE");
  app.add_option("--color-by", options.ColorBy, "the quantity shown by colours (default: height)")
    ->check(CLI::IsMember(GetColorByNames()));
  app.add_option("--point-size", options.PointSize, "side of a point [pixels] (default: 2)")
    ->check(CLI::Range(1.0, 50.0))
    ->option_text("P");
  app.add_option("--size", size, "size of the window or the picture [pixels] (default: 1280x800)")
    ->option_text("WxH");
  app.add_option("--theme", options.Theme, "dark or light colours (default: dark)")
    ->check(CLI::IsMember(GetThemeNames()));
  app.add_flag("!--no-eye-dome", options.EyeDome, "without eye-dome lighting (depth shading)");
  app.add_flag("!--no-fan", options.Fan, "without the latest beams");
  app.add_flag("!--no-words", options.Words, "without text, legend and scale bar over the picture");
}

void AddOutputs(CLI::App& app, ViewerOptions& options)
{
  app.add_flag("--offscreen", options.Offscreen, "no window: for --record and --still");
  app
    .add_option("--record", options.Record,
      "a video, .ogv (Ogg Theora), or one picture per frame, frame%04d.png")
    ->option_text("FILE");
  app
    .add_option("--seconds", options.Seconds,
      "duration of the recording; the survey is played in this time, unless --speed is given "
      "(default: 10)")
    ->check(CLI::Range(0.04, 86400.0))
    ->option_text("S");
  app
    .add_option(
      "--fps", options.FramesPerSecond, "frames per second of the recording (default: 25)")
    ->check(CLI::Range(1.0, 120.0))
    ->option_text("N");
  app.add_option("--still", options.Still, "a picture (PNG) of the final state")
    ->option_text("FILE.png");
  app
    .add_option(
      "--state", options.State, "maintain a JSON file that describes the display, for scripts")
    ->option_text("FILE.json");
  app
    .add_option("--save", options.Save,
      "file to which s saves the edited survey (default: survey.xml in this folder)")
    ->option_text("FILE.xml");
}

/// Reads "1280x800"; false if not valid.
bool ReadSize(const std::string& text, ViewerOptions& options)
{
  std::smatch parts;
  if (!std::regex_match(text, parts, std::regex("([0-9]{2,5})x([0-9]{2,5})")))
  {
    return false;
  }
  options.Width = std::stoi(parts[1]);
  options.Height = std::stoi(parts[2]);
  return options.Width >= 64 && options.Height >= 64 && options.Width <= 16384 &&
    options.Height <= 16384;
}

bool ReadSpeed(const std::string& text, ViewerOptions& options)
{
  options.FullSpeed = text == "max";
  if (options.FullSpeed)
  {
    return true;
  }
  std::size_t used = 0;
  try
  {
    options.Speed = std::stod(text, &used);
  }
  catch (const std::exception&)
  {
    return false;
  }
  return used == text.size() && options.Speed >= 0.01 && options.Speed <= 1000.0;
}

/// Returns an error if options exclude each other.
Status CheckTogether(const ViewerOptions& options)
{
  if (options.Offscreen && options.Record.empty() && options.Still.empty())
  {
    return Status::Error("--offscreen shows nothing by itself: give --record or --still");
  }
  return options.Seconds > 0.0 && options.Record.empty()
    ? Status::Error("--seconds is the length of a recording: give --record, too")
    : Status();
}

OptionsResult ReportError(const std::string& text)
{
  std::cerr << "error: " << text << "\n";
  return OptionsResult::Wrong;
}

} // namespace

//------------------------------------------------------------------------------
OptionsResult ReadOptions(int argc, char** argv, ViewerOptions& options)
{
  CLI::App app(
    "Shows a survey while it runs, the replay of a run, clouds or scenes.", "vtkhelios view");
  std::string speed;
  std::string size;
  app.footer(Epilog);
  app.set_version_flag("--version", std::string("vtkhelios ") + vtkHeliosVersion::GetVersion());
  AddInputs(app, options);
  AddTime(app, options, speed);
  AddLook(app, options, size);
  AddOutputs(app, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    const bool isHelp = error.get_exit_code() == 0;
    isHelp ? app.exit(error) : app.exit(error, std::cerr, std::cerr);
    return isHelp ? OptionsResult::Done : OptionsResult::Wrong;
  }
  options.HasSpeed = !speed.empty();
  if (!speed.empty() && !ReadSpeed(speed, options))
  {
    return ReportError("--speed " + speed + ": give 0.01 to 1000, or max");
  }
  if (!size.empty() && !ReadSize(size, options))
  {
    return ReportError("--size " + size + ": give WIDTHxHEIGHT, 64x64 to 16384x16384");
  }
  const Status status = CheckTogether(options);
  return status.IsOk() ? OptionsResult::Go : ReportError(status.Message());
}

} // namespace helios::viewer
