// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosExpressionErrorModel
 * @brief   systematic errors of an instrument as expressions
 *
 * Expressions as in HELIOS files: numbers, pi, e, the variable t (or THETA), + - *
 * / ^, brackets, and the functions exp ln sqrt abs cos sin tan acos asin atan cosh
 * sinh tanh atan2(a, b), up to 1000 characters and 100 nested brackets. An empty
 * one is no error. One that cannot be parsed, or has no finite value for any angle
 * or range, is rejected with an error, and the previous one is kept; if it has no
 * finite value for some, the scanner fails.
 *
 * @sa
 * vtkHeliosErrorModel vtkHeliosScanner
 */

#ifndef vtkHeliosExpressionErrorModel_h
#define vtkHeliosExpressionErrorModel_h

#include "vtkHeliosErrorModel.h"
#include "vtkHeliosScannerDetectorsModule.h" // For export macro

#include <memory> // For the expressions
#include <string> // For the expressions

namespace helios
{
class Expression;
}

class VTKHELIOSSCANNERDETECTORS_EXPORT vtkHeliosExpressionErrorModel : public vtkHeliosErrorModel
{
public:
  static vtkHeliosExpressionErrorModel* New();
  vtkTypeMacro(vtkHeliosExpressionErrorModel, vtkHeliosErrorModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the error added to a range [m], to the deflector angle and to the head
   * angle [rad]; the variable is the exact deflector angle [rad]. Default: empty.
   */
  void SetRangeErrorExpression(const std::string& text);
  std::string GetRangeErrorExpression() const;
  void SetDeflectionErrorExpression(const std::string& text);
  std::string GetDeflectionErrorExpression() const;
  void SetHeadErrorExpression(const std::string& text);
  std::string GetHeadErrorExpression() const;
  ///@}

  ///@{
  /**
   * Set/Get the factor on the range noise; the variable is the range [m].
   * Default: empty.
   */
  void SetRangeNoiseFactorExpression(const std::string& text);
  std::string GetRangeNoiseFactorExpression() const;
  ///@}

  ///@{
  /**
   * Set/Get the distance by which the angle in the head's expression is moved from
   * the multiples of pi, where its sine vanishes [deg]. Valid range: [0, 90].
   * Default: 0.
   */
  vtkSetClampMacro(ZeroSinThreshold, double, 0.0, 90.0);
  vtkGetMacro(ZeroSinThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get the name of a term in messages, such as file:line and the attribute.
   * Default: the property with its expression.
   */
  void SetTermName(int term, const std::string& name);
  std::string GetTermName(int term) const override;
  ///@}

  /**
   * Returns an error message with a remedy; empty for a valid expression.
   */
  static std::string FindFault(const std::string& text);

  ///@{
  /**
   * Returns the values of the expressions, which may be non-finite. Thread-safe.
   */
  double GetRangeError(double theta) const override;
  double GetDeflectionError(double theta) const override;
  double GetHeadError(double theta) const override;
  double GetRangeNoiseFactor(double range) const override;
  ///@}

protected:
  vtkHeliosExpressionErrorModel();
  ~vtkHeliosExpressionErrorModel() override;

private:
  vtkHeliosExpressionErrorModel(const vtkHeliosExpressionErrorModel&) = delete;
  void operator=(const vtkHeliosExpressionErrorModel&) = delete;

  struct Term;
  Term& GetTerm(int term) const;
  void SetTerm(Term& term, const std::string& text);

  std::unique_ptr<Term> Range;
  std::unique_ptr<Term> Deflection;
  std::unique_ptr<Term> Head;
  std::unique_ptr<Term> NoiseFactor;
  double ZeroSinThreshold = 0.0;
};

#endif
