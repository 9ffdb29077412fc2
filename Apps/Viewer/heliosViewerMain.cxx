// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDisplay.h"
#include "heliosSignals.h"
#include "heliosStatus.h"
#include "heliosViewer.h"
#include "heliosViewerOptions.h"
#include "vtkHeliosEchoDetection.h"

#include <vtkObject.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <streambuf>
#include <string>

namespace
{

/**
 * During its lifetime, control characters written to a stream, except tab and line feed, are
 * escaped as \x1b etc. Bytes of other characters pass.
 */
class VisibleText : public std::streambuf
{
public:
  explicit VisibleText(std::ostream& stream)
    : Stream(stream)
    , Target(stream.rdbuf(this))
  {
  }
  ~VisibleText() override { this->Stream.rdbuf(this->Target); }
  VisibleText(const VisibleText&) = delete;
  void operator=(const VisibleText&) = delete;

protected:
  int_type overflow(int_type character) override
  {
    const bool isControl = (character >= 0 && character < 0x20) || character == 0x7f;
    if (!isControl || character == '\t' || character == '\n')
    {
      return traits_type::eq_int_type(character, traits_type::eof())
        ? traits_type::not_eof(character)
        : this->Target->sputc(traits_type::to_char_type(character));
    }
    char escape[8];
    const int length = std::snprintf(escape, sizeof escape, "\\x%02x", character);
    return this->Target->sputn(escape, length) == length ? character : traits_type::eof();
  }
  int sync() override { return this->Target->pubsync(); }

private:
  std::ostream& Stream;
  std::streambuf* Target;
};

} // namespace

int main(int argc, char** argv)
{
  helios::viewer::EndOnSignals();
  const VisibleText visible(std::cerr);
  helios::viewer::ViewerOptions options;
  const helios::viewer::OptionsResult result = helios::viewer::ReadOptions(argc, argv, options);
  if (result != helios::viewer::OptionsResult::Go)
  {
    return result == helios::viewer::OptionsResult::Done ? 0 : 2;
  }
  const helios::Status status = helios::viewer::CheckDisplay();
  std::string fault = status.Message();
  for (const std::string& file : options.Plugins)
  {
    fault = fault.empty() ? vtkHeliosEchoDetection::LoadPlugin(file) : fault;
  }
  if (!fault.empty())
  {
    std::cerr << "error: " << fault << "\n";
    return 1;
  }
  helios::viewer::ExplainLostDisplay();
  try
  {
    helios::viewer::Viewer viewer(options);
    return viewer.Run();
  }
  catch (const std::exception& error) // from libraries, out of memory
  {
    std::cerr << "error: " << error.what() << "\n";
    return 1;
  }
}
