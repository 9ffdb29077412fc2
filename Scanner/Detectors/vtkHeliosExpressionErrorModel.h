// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosExpressionErrorModel
 * @brief   the errors of an instrument as expressions
 *
 * Expressions as in HELIOS files: numbers, pi, e, the variable t (or THETA),
 * + - * / ^, brackets, and the functions exp ln sqrt abs cos sin tan acos asin
 * atan cosh sinh tanh atan2(a, b), up to 1000 characters and 100 brackets within
 * one another. An empty one is no error. One that cannot be read, or has no finite
 * value for any angle or range, is refused with an error, and the one before it
 * stays; where one has no finite value for some, the scanner fails.
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
   * Set/Get what is added to a range [m], to the angle of the deflector and to that
   * of the head [rad]; the variable is the exact angle of the deflector [rad].
   * Default: empty.
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
   * Set/Get what the range noise is multiplied by; the variable is the range [m].
   * Default: empty.
   */
  void SetRangeNoiseFactorExpression(const std::string& text);
  std::string GetRangeNoiseFactorExpression() const;
  ///@}

  ///@{
  /**
   * Set/Get how far the angle in the head's expression is moved from the multiples
   * of pi, where its sine vanishes [deg]. Valid range: [0, 90]. Default: 0.
   */
  vtkSetClampMacro(ZeroSinThreshold, double, 0.0, 90.0);
  vtkGetMacro(ZeroSinThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get how messages name a term, such as file:line and the attribute. Default:
   * the property with its expression.
   */
  void SetTermName(int term, const std::string& name);
  std::string GetTermName(int term) const override;
  ///@}

  /**
   * What is wrong with an expression and how to mend it; nothing: it can be set.
   */
  static std::string FindFault(const std::string& text);

  ///@{
  /**
   * The values of the expressions, which may be not finite. Thread-safe.
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
