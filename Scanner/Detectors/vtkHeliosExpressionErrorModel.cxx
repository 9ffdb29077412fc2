// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosExpressionErrorModel.h"

#include "heliosExpression.h"
#include "heliosStatus.h"

#include <vtkMath.h>
#include <vtkObjectFactory.h>

#include <cmath>

vtkStandardNewMacro(vtkHeliosExpressionErrorModel);

/// One of the expressions.
struct vtkHeliosExpressionErrorModel::Term
{
  std::string Property;
  std::string Text;
  std::unique_ptr<helios::Expression> Expression; // null: empty
  std::string Name;                               // in messages; empty: the property

  double Evaluate(double variable, double without) const
  {
    return this->Expression ? this->Expression->Evaluate(variable) : without;
  }
};

//------------------------------------------------------------------------------
vtkHeliosExpressionErrorModel::vtkHeliosExpressionErrorModel()
  : Range(new Term{ "RangeErrorExpression", "", nullptr, "" })
  , Deflection(new Term{ "DeflectionErrorExpression", "", nullptr, "" })
  , Head(new Term{ "HeadErrorExpression", "", nullptr, "" })
  , NoiseFactor(new Term{ "RangeNoiseFactorExpression", "", nullptr, "" })
{
}

//------------------------------------------------------------------------------
vtkHeliosExpressionErrorModel::~vtkHeliosExpressionErrorModel() = default;

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::FindFault(const std::string& text)
{
  return helios::Expression::FindFault(text).Message();
}

//------------------------------------------------------------------------------
vtkHeliosExpressionErrorModel::Term& vtkHeliosExpressionErrorModel::GetTerm(int term) const
{
  return term == RANGE_ERROR   ? *this->Range
    : term == DEFLECTION_ERROR ? *this->Deflection
    : term == HEAD_ERROR       ? *this->Head
                               : *this->NoiseFactor;
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetTermName(int term, const std::string& name)
{
  this->GetTerm(term).Name = name;
}

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::GetTermName(int term) const
{
  const Term& named = this->GetTerm(term);
  return named.Name.empty() ? named.Property + " \"" + named.Text + "\"" : named.Name;
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetTerm(Term& term, const std::string& text)
{
  const helios::Status status = helios::Expression::FindFault(text);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< term.Property << " \"" << helios::Expression::Shorten(text)
                  << "\": " << status.Message());
    return;
  }
  if (term.Text != text)
  {
    term.Text = text;
    term.Expression = text.empty() ? nullptr : std::make_unique<helios::Expression>(text);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetRangeErrorExpression(const std::string& text)
{
  this->SetTerm(*this->Range, text);
}

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::GetRangeErrorExpression() const
{
  return this->Range->Text;
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetDeflectionErrorExpression(const std::string& text)
{
  this->SetTerm(*this->Deflection, text);
}

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::GetDeflectionErrorExpression() const
{
  return this->Deflection->Text;
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetHeadErrorExpression(const std::string& text)
{
  this->SetTerm(*this->Head, text);
}

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::GetHeadErrorExpression() const
{
  return this->Head->Text;
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::SetRangeNoiseFactorExpression(const std::string& text)
{
  this->SetTerm(*this->NoiseFactor, text);
}

//------------------------------------------------------------------------------
std::string vtkHeliosExpressionErrorModel::GetRangeNoiseFactorExpression() const
{
  return this->NoiseFactor->Text;
}

//------------------------------------------------------------------------------
double vtkHeliosExpressionErrorModel::GetRangeError(double theta) const
{
  return this->Range->Evaluate(theta, 0.0);
}

//------------------------------------------------------------------------------
double vtkHeliosExpressionErrorModel::GetDeflectionError(double theta) const
{
  return this->Deflection->Evaluate(theta, 0.0);
}

//------------------------------------------------------------------------------
double vtkHeliosExpressionErrorModel::GetHeadError(double theta) const
{
  const double minimum = vtkMath::RadiansFromDegrees(this->ZeroSinThreshold);
  const double zero = vtkMath::Pi() * std::round(theta / vtkMath::Pi());
  const double rest = theta - zero;
  const double moved = std::abs(rest) < minimum ? zero + std::copysign(minimum, rest) : theta;
  return this->Head->Evaluate(moved, 0.0);
}

//------------------------------------------------------------------------------
double vtkHeliosExpressionErrorModel::GetRangeNoiseFactor(double range) const
{
  return this->NoiseFactor->Evaluate(range, 1.0);
}

//------------------------------------------------------------------------------
void vtkHeliosExpressionErrorModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Term* term :
    { this->Range.get(), this->Deflection.get(), this->Head.get(), this->NoiseFactor.get() })
  {
    os << indent << term->Property << ": " << (term->Text.empty() ? "(none)" : term->Text) << "\n";
  }
  os << indent << "ZeroSinThreshold: " << this->ZeroSinThreshold << " deg\n";
}
