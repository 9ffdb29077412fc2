// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosErrorModel
 * @brief   systematic errors of an instrument
 *
 * A strategy, const and thread-safe once set up. Errors of deflector and head
 * turn and move the emitted pulse; its points are placed at the exact angles, at the
 * range with the range error.
 *
 * To add one: subclass and override the nonzero terms. Values are within
 * [-1e9, 1e9]: pulses with a value that is not finite or outside this range are
 * counted and have no output, and the scanner fails with an error.
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
   * The methods below that are overridden.
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
   * Returns the error added to a range [m], to the deflector angle and to the head angle [rad], for
   * the exact deflector angle theta [rad]. Default: 0.
   */
  virtual double GetRangeError(double theta) const;
  virtual double GetDeflectionError(double theta) const;
  virtual double GetHeadError(double theta) const;
  ///@}

  /**
   * Moves the origin [m] and turns the direction (a unit vector) of the emitted ray in the frame of
   * the head, whose rotation axis is z with the default axis: given as they are reported, returned
   * as they are. Returns false, and leaves both, if there is no error. Called after the errors of
   * the angles above. Default: no error.
   */
  virtual bool MoveRay(double origin[3], double direction[3]) const;

  /**
   * Returns the factor on the range noise at a range [m]. Default: 1.
   */
  virtual double GetRangeNoiseFactor(double range) const;

  /**
   * Returns the name of a term in messages. Default: its method.
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
