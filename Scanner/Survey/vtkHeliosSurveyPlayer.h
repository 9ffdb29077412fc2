// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyPlayer
 * @brief   runs the legs of a survey
 */

#ifndef vtkHeliosSurveyPlayer_h
#define vtkHeliosSurveyPlayer_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyPlayer : public vtkObject
{
public:
  static vtkHeliosSurveyPlayer* New();
  vtkTypeMacro(vtkHeliosSurveyPlayer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSurveyPlayer();
  ~vtkHeliosSurveyPlayer() override;

private:
  vtkHeliosSurveyPlayer(const vtkHeliosSurveyPlayer&) = delete;
  void operator=(const vtkHeliosSurveyPlayer&) = delete;
};

#endif
