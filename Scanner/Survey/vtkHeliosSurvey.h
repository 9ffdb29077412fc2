// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurvey
 * @brief   a survey as plain data
 *
 * A scene, a scanner on a platform, and the legs to scan, as read by vtkHeliosSurveyReader and run
 * by vtkHeliosSurveyPlayer. All references, inherited values and limits are resolved. C++ code
 * accesses the data with GetData(); the wrapped methods describe the survey.
 *
 * @sa
 * vtkHeliosSurveyReader vtkHeliosSurveyPlayer
 */

#ifndef vtkHeliosSurvey_h
#define vtkHeliosSurvey_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For the private data
#include <string> // For the names

namespace helios
{
struct LegData;
struct SurveyData;
}

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurvey : public vtkObject
{
public:
  static vtkHeliosSurvey* New();
  vtkTypeMacro(vtkHeliosSurvey, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The name of the survey, also that of its output folder.
   */
  std::string GetName() const;

  ///@{
  /**
   * The names of what the survey uses, separated by commas.
   */
  std::string GetScannerName() const;
  std::string GetPlatformName() const;
  std::string GetSceneName() const;
  ///@}

  /**
   * The seed of the survey; -1: none.
   */
  vtkIdType GetSeed() const;

  /**
   * Whether a platform moves from leg to leg. Its last leg is then an end point only.
   */
  bool IsMoving() const;

  /**
   * The number of epochs: more than one if parts of the scene are swapped. vtkHeliosSurveyPlayer
   * runs one epoch at a time.
   */
  int GetNumberOfPlays() const;

  ///@{
  /**
   * The parts of the scene; the name is empty if the part does not exist.
   */
  int GetNumberOfParts() const;
  std::string GetPartName(int part) const;
  ///@}

  /**
   * The number of legs, including inactive ones.
   */
  int GetNumberOfLegs() const;

  /**
   * The position of a leg in the survey file [m]: for a leg that IsLegOnGround(), z is not yet on
   * the ground. Zero if the leg does not exist.
   */
  void GetLegPosition(int leg, double position[3]) const;

  ///@{
  /**
   * Whether a leg is placed on the ground; whether it fires pulses.
   */
  bool IsLegOnGround(int leg) const;
  bool IsLegActive(int leg) const;
  ///@}

  ///@{
  /**
   * The pulse frequency [Hz] and the scan frequency [Hz] of a leg; 0 if it does not exist.
   */
  double GetLegPulseFrequency(int leg) const;
  double GetLegScanFrequency(int leg) const;
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /// All data; call Modified() after a change.
  helios::SurveyData& GetData()
  {
    return *this->Data;
  }
  const helios::SurveyData& GetData() const
  {
    return *this->Data;
  }
  ///@}
#endif

protected:
  vtkHeliosSurvey();
  ~vtkHeliosSurvey() override;

private:
  vtkHeliosSurvey(const vtkHeliosSurvey&) = delete;
  void operator=(const vtkHeliosSurvey&) = delete;

  const helios::LegData* FindLeg(int leg) const;

  std::unique_ptr<helios::SurveyData> Data;
};

#endif
