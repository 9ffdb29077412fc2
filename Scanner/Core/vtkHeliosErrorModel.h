// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosErrorModel
 * @brief   what an instrument gets wrong in a way that can be written down
 *
 * A strategy, const and thread-safe once set up. The pulse goes where the errors
 * of deflector and head turn it; its points are placed where the exact angles
 * say, at the range with the range error.
 *
 * To add one: subclass and override what is not zero.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosErrorModel_h
#define vtkHeliosErrorModel_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosErrorModel : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosErrorModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is added to a range [m], to the angle of the deflector and to that of
   * the head [rad], for the exact angle theta of the deflector [rad].
   * Default: 0.
   */
  virtual double GetRangeError(double theta) const;
  virtual double GetDeflectionError(double theta) const;
  virtual double GetHeadError(double theta) const;
  ///@}

  /**
   * What the range noise is multiplied by, for a range [m]. Default: 1.
   */
  virtual double GetRangeNoiseFactor(double range) const;

protected:
  vtkHeliosErrorModel() = default;
  ~vtkHeliosErrorModel() override = default;

private:
  vtkHeliosErrorModel(const vtkHeliosErrorModel&) = delete;
  void operator=(const vtkHeliosErrorModel&) = delete;
};

#endif
