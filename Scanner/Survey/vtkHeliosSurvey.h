// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurvey
 * @brief   a survey as plain data
 */

#ifndef vtkHeliosSurvey_h
#define vtkHeliosSurvey_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurvey : public vtkObject
{
public:
  static vtkHeliosSurvey* New();
  vtkTypeMacro(vtkHeliosSurvey, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSurvey();
  ~vtkHeliosSurvey() override;

private:
  vtkHeliosSurvey(const vtkHeliosSurvey&) = delete;
  void operator=(const vtkHeliosSurvey&) = delete;
};

#endif
