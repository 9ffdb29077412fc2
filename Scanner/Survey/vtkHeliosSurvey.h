// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurvey
 * @brief   a scene, a scanner on a platform, and the legs to scan
 *
 * It is read by vtkHeliosSurveyReader, or made by its methods, and run by vtkHeliosSurveyPlayer:
 *
 * @code
 * survey->AddAssetDirectory("Data/Assets"); const int scanner =
 * survey->AddScannerFromFile("scanners.xml#vz400_class_tls"); const int platform =
 * survey->AddPlatformFromFile("platforms.xml#tripod"); const int leg = survey->AddLeg(scanner,
 * platform); survey->SetLegAttribute(leg, "scanFreq_hz", "100"); if (!survey->Check()) ...
 * @endcode
 *
 * Attributes have the names, units and ranges of the HELIOS XML dialect (Docs/dialect.md), and
 * their values are texts, as in files. A value that is not valid is an error, and is not set; an
 * empty one removes it, so that it is inherited or the default. Attributes of elements inside are named by their path, those that
 * repeat with an index, as in scannerMount/rot[1]/axis and dmotion[0]/motion[1]/angle; an index left
 * out is 0, and that after the last adds an element. The value of an element itself is true, and an
 * empty one removes it. Elements of other files are changed in a copy. Changes that depend on each other, such as the limits of a
 * scanner and the settings of a leg, are resolved together: Check() reports all errors and
 * warnings. Messages name "leg 2", "scanner 0" or "platform 0" in place of file:line. All indices
 * count from 0.
 *
 * C++ code accesses the data with GetData(): all references, inherited values and limits are
 * resolved there.
 *
 * @sa
 * vtkHeliosSurveyReader vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosSurvey_h
#define vtkHeliosSurvey_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the private data
#include <string> // For names and values

namespace helios
{
struct LegData;
struct SurveyData;
class SurveyDocument;
}

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurvey : public vtkObject
{
public:
  static vtkHeliosSurvey* New();
  vtkTypeMacro(vtkHeliosSurvey, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the name of the survey and of its output folder; it is changed to a valid folder name.
   * Default: survey.
   */
  void SetName(const std::string& name);
  std::string GetName() const;
  ///@}

  ///@{
  /**
   * Adds an asset directory (and its folder data) to search for references, after those added
   * before; remove all. The working directory is searched last. Default: none.
   */
  void AddAssetDirectory(const std::string& directory);
  void RemoveAllAssetDirectories();
  ///@}

  ///@{
  /**
   * Set/Get an attribute of the survey (name, seed, rayCaster, legRandomOffset ...) or of its scene
   * (id, name, crs). Set returns false after an error; Get returns an empty string if the value is
   * not given.
   */
  bool SetSurveyAttribute(const std::string& name, const std::string& value);
  std::string GetSurveyAttribute(const std::string& name);
  bool SetSceneAttribute(const std::string& name, const std::string& value);
  std::string GetSceneAttribute(const std::string& name);
  ///@}

  ///@{
  /**
   * Adds a scanner or a platform: one with the default attributes, or file.xml#id. Returns its
   * index for AddLeg(), or -1 after an error.
   */
  int AddScanner(const std::string& id);
  int AddPlatform(const std::string& id);
  int AddScannerFromFile(const std::string& reference);
  int AddPlatformFromFile(const std::string& reference);
  ///@}

  /**
   * Names what the survey consists of as it is given, file.xml#id or, of the scene, a mesh; empty: not
   * changed. They may not exist yet: Check() finds them.
   */
  void SetSources(
    const std::string& scene, const std::string& platform, const std::string& scanner);

  ///@{
  /**
   * Get the number of scanners and of platforms.
   */
  int GetNumberOfScanners() const;
  int GetNumberOfPlatforms() const;
  ///@}

  ///@{
  /**
   * Set/Get an attribute of a scanner by its name in scanner, FWFSettings or detectorSettings:
   * optics, beamDivergence_rad, binSize_ns ..., or of a child element, as in beamOrigin/z,
   * headRotateAxis/y, channel/id or rangeError/expr. Set changes all channels, Get is for the first one.
   */
  bool SetScannerAttribute(int scanner, const std::string& name, const std::string& value);
  std::string GetScannerAttribute(int scanner, const std::string& name);
  ///@}

  ///@{
  /**
   * Adds a channel, a copy of the first one, which is the scanner itself. Returns its index, or -1
   * after an error. Set/Get an attribute of one channel.
   */
  int AddChannel(int scanner);
  int GetNumberOfChannels(int scanner);
  bool SetChannelAttribute(
    int scanner, int channel, const std::string& name, const std::string& value);
  std::string GetChannelAttribute(int scanner, int channel, const std::string& name);
  ///@}

  ///@{
  /**
   * Set/Get an attribute of a platform: type, roll_speed_deg ..., or of a child element, as in
   * scannerMount/z, scannerMount/rot[0]/angle_deg or positionXNoise/stdev, which switches that noise
   * on. The type interpolated follows the trajectory of its legs, or that of input 2 of
   * vtkHeliosSurveySource.
   */
  bool SetPlatformAttribute(int platform, const std::string& name, const std::string& value);
  std::string GetPlatformAttribute(int platform, const std::string& name);
  ///@}

  /**
   * Adds a leg with the default settings, for one of the scanners on one of the platforms. Returns
   * its index, or -1 after an error. On a moving platform a leg extends to the position of the next
   * leg with the same platform, and the last one is its end.
   */
  int AddLeg(int scanner = 0, int platform = 0);

  ///@{
  /**
   * Removes a leg, or all legs; those after it move up. Does nothing if the leg does not exist.
   */
  void RemoveLeg(int leg);
  void RemoveAllLegs();
  ///@}

  /**
   * Move a leg to another place among the legs; those between move by one. Returns false after an
   * error.
   */
  bool MoveLeg(int leg, int to);

  ///@{
  /**
   * Set/Get a setting of a leg by its name in platformSettings, scannerSettings or leg: x, y, z,
   * onGround, movePerSec_m, scanFreq_hz ... Get returns the setting as given, before inheritance
   * and limits, and an empty string if it is not given.
   */
  bool SetLegAttribute(int leg, const std::string& name, const std::string& value);
  std::string GetLegAttribute(int leg, const std::string& name);
  ///@}

  /**
   * Sets the position of a leg [m]; z is replaced by the height of the ground for a leg with
   * onGround. Returns false after an error.
   */
  bool SetLegPosition(int leg, double x, double y, double z);

  ///@{
  /**
   * Adds a part of the scene from a file, by a loader: objloader, geotiffloader, xyzloader,
   * detailedvoxels, plyloader, stlloader, cityjsonloader, gltfloader or lasloader. Returns its
   * index, or -1 after an error. Remove all parts.
   */
  int AddPart(const std::string& loader, const std::string& file);
  void RemoveAllParts();
  ///@}

  ///@{
  /**
   * Set/Get an attribute of a part: id, dynStep ..., or the parameter of a filter, as in
   * translate/offset, xyzloader/voxelSize, geotiffloader/matfile, crs[0]/target or repair; of its
   * motions, as in dmotion[0]/motion[0]/vec; and of its replacements in later epochs, as in
   * swap[0]/swapStep or swap[0]/translate/offset.
   */
  bool SetPartAttribute(int part, const std::string& name, const std::string& value);
  std::string GetPartAttribute(int part, const std::string& name);
  ///@}

  /**
   * Remove one part that is not of a table; those after it move up. Returns false after an error.
   */
  bool RemovePart(int part);

  /**
   * Add a table of parts, a row for each place where a model stands: a CSV file, or an empty name for
   * a table with the rows of SetPartTableAttribute() or SetPartTableRows(). Its parts come after all
   * others. Returns its index, or -1 after an error. RemoveAllParts() removes tables, too.
   */
  int AddPartTable(const std::string& file);

  ///@{
  /**
   * Set/Get an attribute of a table: seed, yawMax_deg ...; of its models, as in model[0]/id or
   * model[0]/objloader/filepath; and of its rows, as in row[0]/x.
   */
  bool SetPartTableAttribute(int table, const std::string& name, const std::string& value);
  std::string GetPartTableAttribute(int table, const std::string& name);
  ///@}

  /**
   * Sets the rows of a table that has no file as the text of a CSV file. Returns false after an
   * error.
   */
  bool SetPartTableRows(int table, const std::string& text);

  /**
   * Rotates a part about x, y or z by an angle [deg], after its other rotations. Valid range:
   * [-1e6, 1e6]. Returns false after an error.
   */
  bool RotatePart(int part, const std::string& axis, double angle);

  ///@{
  /**
   * Get the names of all attributes of a kind that have one value: survey, scene, part, scanner,
   * platform or leg; none of another kind, and empty if the index is out of range.
   */
  static int GetNumberOfAttributes(const std::string& kind);
  static std::string GetAttributeName(const std::string& kind, int index);
  ///@}

  /**
   * Write the survey, however it was made, to an XML file, which reads back as the same survey with the
   * same asset directories. What it refers to in other files stays there, unless it was changed; files
   * are named from the new folder. An existing file is replaced. Returns false after an error.
   */
  bool WriteFile(const std::string& fileName);

  /**
   * Returns the text of a file with the scene, a scanner or a platform (kind) of this survey alone, after
   * a comment; files are named from its folder. Empty after an error, or if the kind is unknown.
   */
  std::string MakeFileText(
    const std::string& kind, int index, const std::string& comment, const std::string& fileName);

  /**
   * Checks the survey: reports all errors and warnings, of scanners and of legs with their
   * inherited values and limits. Returns false after an error. A survey that has not changed since
   * it was checked, or read without error, is valid. Scene and trajectory are not required: they
   * may be inputs of a vtkHeliosSurveySource.
   */
  bool Check();

  ///@{
  /**
   * Returns the names of what the survey uses, separated by commas.
   */
  std::string GetScannerName() const;
  std::string GetPlatformName() const;
  std::string GetSceneName() const;
  ///@}

  /**
   * Returns the seed of the survey; -1: none.
   */
  vtkIdType GetSeed() const;

  /**
   * Returns whether a platform moves from leg to leg. Its last leg is then an end point only.
   */
  bool IsMoving() const;

  /**
   * Returns the number of epochs: more than one if parts of the scene are swapped.
   * vtkHeliosSurveyPlayer runs one epoch at a time.
   */
  int GetNumberOfEpochs() const;

  ///@{
  /**
   * The parts of the scene; those that are not of tables come first, and can be changed one by one.
   * The name is empty if the part does not exist. GetPartMotion() describes how a part moves during
   * the survey, by itself or carried: "along car.csv"; empty if it does not.
   */
  int GetNumberOfParts() const;
  int GetNumberOfSingleParts();
  std::string GetPartName(int part) const;
  std::string GetPartMotion(int part) const;
  ///@}

  /**
   * Returns the number of legs, including inactive ones.
   */
  int GetNumberOfLegs() const;

  /**
   * Gets the position of a leg [m]: for a leg that IsLegOnGround(), z is not yet on the ground.
   * Zero if the leg does not exist.
   */
  void GetLegPosition(int leg, double position[3]) const;

  ///@{
  /**
   * Returns whether a leg is placed on the ground; whether it fires pulses.
   */
  bool IsLegOnGround(int leg) const;
  bool IsLegActive(int leg) const;
  ///@}

  ///@{
  /**
   * Returns the pulse frequency [Hz] and the scan frequency [Hz] of a leg; 0 if it does not exist.
   */
  double GetLegPulseFrequency(int leg) const;
  double GetLegScanFrequency(int leg) const;
  ///@}

#ifndef __VTK_WRAP__
  /// Replaces the survey by a document, whose errors are reported for an owner. False after an error.
  bool ReadDocument(std::unique_ptr<helios::SurveyDocument> document, vtkObject* owner);

  /// @{
  /// Returns all data; call Modified() after a change. A leg is changed by its settings: the
  /// methods above make all legs of theirs again.
  helios::SurveyData& GetData();
  const helios::SurveyData& GetData() const;
  ///@}
#endif

protected:
  vtkHeliosSurvey();
  ~vtkHeliosSurvey() override;

private:
  vtkHeliosSurvey(const vtkHeliosSurvey&) = delete;
  void operator=(const vtkHeliosSurvey&) = delete;

  const helios::LegData* FindLeg(int leg) const;

  class Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
