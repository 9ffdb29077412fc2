// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosRunFiles
 * @brief   names of the files of a run
 *
 * A run writes into the folder of its survey or, of a survey with several epochs, into the
 * subfolder epochNNN, a part of a run into the subfolder partNNNofNNN of that: run.journal while it runs, run_summary.json at its end, and of each leg, or of
 * the legs of a strip S:
 * - legNNN_points, stripS_points: echoes
 * - legNNN_fullwave: waveforms
 * - legNNN_pulse: pulses
 * - legNNN_trajectory: the trajectory
 *
 * Numbers and S have at least three characters. Then follows _dev and the channel in files of one
 * channel, and the ending of the format. Unfinished files end in
 * vtkHeliosStreamWriter::GetPartEnding().
 *
 * Names are without a folder.
 */

#ifndef vtkHeliosRunFiles_h
#define vtkHeliosRunFiles_h

#include "vtkHeliosScannerRunModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For names

class VTKHELIOSSCANNERRUN_EXPORT vtkHeliosRunFiles : public vtkObject
{
public:
  static vtkHeliosRunFiles* New();
  vtkTypeMacro(vtkHeliosRunFiles, vtkObject);

  /**
   * Kind of the contents of a file; the first four are the output ports of vtkHeliosScanner.
   */
  enum FileKind
  {
    POINTS,
    WAVEFORMS,
    PULSES,
    HITS,
    TRAJECTORY
  };

  ///@{
  /**
   * Returns the files of a whole run.
   */
  static const char* GetSummaryName();
  static const char* GetJournalName();
  ///@}

  ///@{
  /**
   * Returns the subfolder of an epoch, and the epoch of a subfolder; -1 for any other folder. FindEpoch()
   * returns its path below a folder: playNNN if an earlier version wrote it there, and there is no other.
   */
  static std::string GetEpochName(int epoch);
  static int GetEpoch(const std::string& folder);
  static std::string FindEpoch(const std::string& folder, int epoch);
  ///@}

  /**
   * Returns the subfolder of a part, counted from 1, of a run in a number of parts: "part002of004".
   */
  static std::string GetPartName(int part, int parts);

  ///@{
  /**
   * Get the formats of a run: "xyz", "las", "laz", "copc", "vtp". Null if the index is out of range.
   * IsLas() returns whether files have records of LAS, IsCompressed() whether these are compressed.
   */
  static int GetNumberOfFormats();
  static const char* GetFormat(int index);
  static bool IsLas(const std::string& format);
  static bool IsCompressed(const std::string& format);
  ///@}

  ///@{
  /**
   * Returns the beginning of the names of a leg's or strip's files: "leg012", "strip00A".
   */
  static std::string GetLegStem(int leg);
  static std::string GetStripStem(const std::string& strip);
  ///@}

  /**
   * Returns the name of a file: its stem, kind (FileKind) and format, and the channel if it has
   * only one. Empty for any other kind or format.
   */
  static std::string GetFileName(const std::string& stem, int kind, const std::string& format,
    const std::string& channel = std::string());

  /**
   * Returns the name of the file of a kind and format that belongs to a file of another kind, also
   * if its stem is neither a leg's nor a strip's. Empty if the name has no kind.
   */
  static std::string GetBeside(const std::string& fileName, int kind, const std::string& format);

  ///@{
  /**
   * Get the kind, the stem, and the number of the leg or strip of a file's name. -1, empty and -1
   * if it is no finished file of a run; -1 if the strip has no number.
   */
  static int GetKind(const std::string& fileName);
  static std::string GetStem(const std::string& fileName);
  static int GetNumber(const std::string& fileName);
  ///@}

  /**
   * Returns whether a name belongs to a file of a leg, finished or not, or to a part of such a
   * file.
   */
  static bool IsOfLeg(const std::string& fileName);

protected:
  vtkHeliosRunFiles() = default;
  ~vtkHeliosRunFiles() override = default;

private:
  vtkHeliosRunFiles(const vtkHeliosRunFiles&) = delete;
  void operator=(const vtkHeliosRunFiles&) = delete;
};

#endif
