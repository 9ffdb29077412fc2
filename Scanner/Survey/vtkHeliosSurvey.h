// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurvey
 * @brief   a survey as plain data
 *
 * A scene, a scanner on a platform, and the legs that it runs, as
 * vtkHeliosSurveyReader reads them and vtkHeliosSurveyPlayer runs them. Nothing
 * is left to look up, to inherit or to clip. C++ reaches the data with
 * GetData(); what is wrapped tells what the survey is.
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
   * The name of the survey, which its output folder gets, too.
   */
  std::string GetName() const;

  ///@{
  /**
   * The names of what the survey uses; where there are several, with commas
   * between them.
   */
  std::string GetScannerName() const;
  std::string GetPlatformName() const;
  std::string GetSceneName() const;
  ///@}

  /**
   * The key of random numbers that the survey asks for; -1: it asks for none.
   */
  vtkIdType GetSeed() const;

  /**
   * Whether a platform moves from leg to leg. The last leg of one is then an end
   * point only.
   */
  bool IsMoving() const;

  /**
   * How often the survey is played: more than once where parts of its scene are
   * swapped. vtkHeliosSurveyPlayer runs one play at a time.
   */
  int GetNumberOfPlays() const;

  ///@{
  /**
   * The parts of the scene; a part's name is empty where there is no such part.
   */
  int GetNumberOfParts() const;
  std::string GetPartName(int part) const;
  ///@}

  /**
   * The number of legs, the inactive ones included.
   */
  int GetNumberOfLegs() const;

  /**
   * The position of a leg as the survey gives it [m]: with z not yet on the
   * ground for a leg that IsLegOnGround(). Zero where there is no such leg.
   */
  void GetLegPosition(int leg, double position[3]) const;

  ///@{
  /**
   * Whether a leg is put onto the ground; whether it fires pulses.
   */
  bool IsLegOnGround(int leg) const;
  bool IsLegActive(int leg) const;
  ///@}

  ///@{
  /**
   * The pulse frequency [Hz] and the scan frequency [Hz] of a leg; 0 where there
   * is no such leg.
   */
  double GetLegPulseFrequency(int leg) const;
  double GetLegScanFrequency(int leg) const;
  ///@}

#ifndef __VTK_WRAP__
  ///@{
  /// All of it; call Modified() after a change.
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
