// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The files that a thread reads: whether they can be read, and which they were.

#ifndef heliosInputFile_h
#define heliosInputFile_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <functional>
#include <map>
#include <string>

namespace helios
{

/**
 * Returns an error if a path cannot be read as a file ("cannot be read: it is a FIFO ..."): folders,
 * FIFOs, sockets, devices and files of /proc and /sys, which may have no end or no size. Regular
 * files are accepted, and missing ones, which the caller reports on opening.
 *
 * All readers call it before they open a file: a regular file is then reported to the InputWatch of
 * the thread.
 */
VTKHELIOSFILTERSCORE_EXPORT Status CheckInputFile(const std::string& path);

/// Returns a text that differs after every change of a file: its size, its times of change, and its
/// number on the disk. Also after changes that set the time of the last change back. Empty: no such
/// file.
VTKHELIOSFILTERSCORE_EXPORT std::string StampFile(const std::string& path);

/// Returns the time since a file, or one of its time stamps, was changed [s]. Negative: by a clock
/// ahead of ours.
VTKHELIOSFILTERSCORE_EXPORT double GetAge(const std::string& path);

/// Files that were opened, each with its StampFile() when it was opened first.
using InputFiles = std::map<std::string, std::string>;

/// Returns whether all files are as they were when they were opened.
VTKHELIOSFILTERSCORE_EXPORT bool AreUnchanged(const InputFiles& files);

/// Receives the input files that its thread opens during its lifetime, in place of an InputWatch
/// that was there before. What other programs read on our behalf is added by CheckInputFile().
class VTKHELIOSFILTERSCORE_EXPORT InputWatch
{
public:
  using OpenCallback = std::function<void(const std::string& path, const std::string& stamp)>;

  explicit InputWatch(OpenCallback onOpen);
  explicit InputWatch(InputFiles& files); ///< adds the files
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  void operator=(const InputWatch&) = delete;

  /// Returns whether the thread has one.
  static bool IsOn();

private:
  OpenCallback OnOpen;
  const OpenCallback* Before; // callback that the thread had before
};

} // namespace helios

#endif
