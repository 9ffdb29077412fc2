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
 * To add one: subclass and override what is not zero. Values are within
 * [-1e9, 1e9]: the scanner counts the pulses for which one is not finite, or
 * beyond, gives no output for them, and fails with an error.
 *
 * @sa
 * vtkHeliosScanner
 */

#ifndef vtkHeliosErrorModel_h
#define vtkHeliosErrorModel_h

#include "vtkHeliosScannerCoreModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For the names of terms

class VTKHELIOSSCANNERCORE_EXPORT vtkHeliosErrorModel : public vtkObject
{
public:
  vtkTypeMacro(vtkHeliosErrorModel, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The methods below that have values.
   */
  enum Terms
  {
    RANGE_ERROR = 0,
    DEFLECTION_ERROR = 1,
    HEAD_ERROR = 2,
    RANGE_NOISE_FACTOR = 3,
    NUMBER_OF_TERMS = 4
  };

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

  /**
   * How messages name a term. Default: its method.
   */
  virtual std::string GetTermName(int term) const;

protected:
  vtkHeliosErrorModel() = default;
  ~vtkHeliosErrorModel() override = default;

private:
  vtkHeliosErrorModel(const vtkHeliosErrorModel&) = delete;
  void operator=(const vtkHeliosErrorModel&) = delete;
};

#endif
