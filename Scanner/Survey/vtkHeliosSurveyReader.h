// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosSurveyReader
 * @brief   a survey from HELIOS XML
 */

#ifndef vtkHeliosSurveyReader_h
#define vtkHeliosSurveyReader_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNERSURVEY_EXPORT vtkHeliosSurveyReader : public vtkObject
{
public:
  static vtkHeliosSurveyReader* New();
  vtkTypeMacro(vtkHeliosSurveyReader, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;



protected:
  vtkHeliosSurveyReader();
  ~vtkHeliosSurveyReader() override;

private:
  vtkHeliosSurveyReader(const vtkHeliosSurveyReader&) = delete;
  void operator=(const vtkHeliosSurveyReader&) = delete;
};

#endif
