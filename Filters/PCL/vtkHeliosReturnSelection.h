// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosReturnSelection
 * @brief   selects points by return and class
 *
 * Input 0: a vtkPolyData with points. Output 0: those that pass all of these tests, bit by bit,
 * with their arrays and the field data; vertices, one per point, if the input has vertices:
 * - Returns, by the point arrays ReturnNumber and NumberOfReturns;
 * - ReturnRange, by ReturnNumber;
 * - the classes of AddClass(), by ClassificationIds.
 *
 * Only the arrays of active tests are needed. Errors: one of them is missing, or is not one integer
 * per point.
 *
 * @sa
 * vtkHeliosPCLGroundFilter
 */

#ifndef vtkHeliosReturnSelection_h
#define vtkHeliosReturnSelection_h

#include "vtkHeliosFiltersPCLModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the classes

class VTKHELIOSFILTERSPCL_EXPORT vtkHeliosReturnSelection : public vtkPolyDataAlgorithm
{
public:
  static vtkHeliosReturnSelection* New();
  vtkTypeMacro(vtkHeliosReturnSelection, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Returns of a pulse. */
  enum ReturnKinds
  {
    AllReturns = 0,
    FirstReturns = 1,        ///< number 1
    LastReturns = 2,         ///< number = number of returns
    OnlyReturns = 3,         ///< the only one of their pulse
    IntermediateReturns = 4, ///< neither first nor last
    FirstOfMany = 5,         ///< first of several
    LastOfMany = 6           ///< last of several
  };

  ///@{
  /**
   * Set/Get which returns of a pulse pass. Valid range: ReturnKinds. Default: AllReturns.
   */
  vtkSetClampMacro(Returns, int, AllReturns, LastOfMany);
  vtkGetMacro(Returns, int);
  void SetReturnsToAll() { this->SetReturns(AllReturns); }
  void SetReturnsToFirst() { this->SetReturns(FirstReturns); }
  void SetReturnsToLast() { this->SetReturns(LastReturns); }
  void SetReturnsToOnly() { this->SetReturns(OnlyReturns); }
  void SetReturnsToIntermediate() { this->SetReturns(IntermediateReturns); }
  ///@}

  ///@{
  /**
   * Set/Get the minimum and maximum ReturnNumber that pass. Valid range: the first not above the
   * second. Default: 0 255: all.
   */
  vtkSetVector2Macro(ReturnRange, int);
  vtkGetVector2Macro(ReturnRange, int);
  ///@}

  ///@{
  /**
   * Adds a class (ClassificationIds) that passes, or removes all; without any, all pass. Valid
   * range: any integer. Default: none.
   */
  void AddClass(int id);
  void RemoveAllClasses();
  int GetNumberOfClasses() const { return static_cast<int>(this->Classes.size()); }
  int GetClass(int index) const;
  ///@}

protected:
  vtkHeliosReturnSelection() = default;
  ~vtkHeliosReturnSelection() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHeliosReturnSelection(const vtkHeliosReturnSelection&) = delete;
  void operator=(const vtkHeliosReturnSelection&) = delete;

  class Test;

  int Returns = AllReturns;
  int ReturnRange[2] = { 0, 255 };
  std::vector<int> Classes;
};

#endif
