// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A table of parts: models, and a row for each place where one of them stands.

#ifndef heliosPartTable_h
#define heliosPartTable_h

#include "heliosSurveyData.h"

#include <limits>
#include <string>
#include <vector>

namespace helios
{

class Messages;

/// A part that rows place.
struct TableModel
{
  PartData Part;      ///< has the name of the model
  double Share = 1.0; ///< share of the rows without a model, in proportion
};

/// A row of a table; NaN: not given.
struct TableRow
{
  static constexpr double NotGiven = std::numeric_limits<double>::quiet_NaN();

  std::string Where;
  std::string Model;       ///< empty: one at random
  double X = NotGiven;     ///< [m]
  double Y = NotGiven;     ///< [m]
  double Z = NotGiven;     ///< [m]; not given: on the ground
  double Yaw = NotGiven;   ///< [deg]
  double Scale = NotGiven; ///< not given: random
  std::string Name;        ///< empty: the number of the part
  int Classification = -1; ///< negative: class of the model
  std::string Species;     ///< empty: that of the model
  int Tree = -1;           ///< number of the tree; negative: the part's
};

struct PartTableData
{
  std::string Where;
  std::string File;    ///< file of the rows; empty: none
  int Seed = 0;        ///< seed for values that rows do not give
  double YawMin = 0.0; ///< [deg]
  double YawMax = 0.0; ///< [deg]
  double ScaleMin = 1.0;
  double ScaleMax = 1.0;
  std::vector<TableModel> Models;
  std::vector<TableRow> Rows;
};

/**
 * Adds a part per row: its model, as placed by the model's own filters, is rotated about the
 * vertical, scaled, and moved. A random value depends on the seed, the number of the row, and what
 * it is for. Rows without a model that exists are errors.
 */
void AddTableParts(const PartTableData& table, std::vector<PartData>& parts, Messages& log);

} // namespace helios

#endif
