// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartTable.h"

#include "heliosMessages.h"
#include "heliosRandom.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace helios
{

namespace
{

double Choose(double given, double low, double high, double random)
{
  return std::isnan(given) ? low + random * (high - low) : given;
}

/// Makes parts of rows.
class RowParts
{
public:
  RowParts(const PartTableData& table, Messages& log)
    : Table(table)
    , Log(log)
  {
    for (const TableModel& model : table.Models)
    {
      this->Models.emplace(model.Part.Name, &model);
      this->Shares += model.Share;
    }
  }

  bool Add(std::size_t index, std::vector<PartData>& parts) const;

private:
  const TableModel* FindModel(const TableRow& row, double random) const;
  const TableModel* ChooseModel(const TableRow& row, double random) const;

  const PartTableData& Table;
  Messages& Log;
  std::map<std::string, const TableModel*> Models;
  double Shares = 0.0;
};

//------------------------------------------------------------------------------
/// Chooses one of the models at random, in proportion to their shares.
const TableModel* RowParts::ChooseModel(const TableRow& row, double random) const
{
  double sum = 0.0;
  for (const TableModel& model : this->Table.Models)
  {
    sum += model.Share;
    if (model.Share > 0.0 && (random * this->Shares < sum || sum >= this->Shares))
    {
      return &model;
    }
  }
  this->Log.Error(row.Where +
    ": model is not given, and the table has no <model> to choose from; give the row a model, or "
    "the table a <model> with a share above 0");
  return nullptr;
}

//------------------------------------------------------------------------------
const TableModel* RowParts::FindModel(const TableRow& row, double random) const
{
  const auto found = this->Models.find(row.Model);
  return row.Model.empty()        ? this->ChooseModel(row, random)
    : found == this->Models.end() ? nullptr // its error was reported
                                  : found->second;
}

//------------------------------------------------------------------------------
/// Adds the part of a row; false after an error.
bool RowParts::Add(std::size_t index, std::vector<PartData>& parts) const
{
  const TableRow& row = this->Table.Rows[index];
  const std::array<double, 4> random =
    Uniform4(static_cast<std::uint64_t>(this->Table.Seed), RandomStream::PartTable, index, 0);
  const TableModel* model = this->FindModel(row, random[0]);
  if (!model)
  {
    return false;
  }
  const double yaw = Choose(row.Yaw, this->Table.YawMin, this->Table.YawMax, random[1]);
  const double scale = Choose(row.Scale, this->Table.ScaleMin, this->Table.ScaleMax, random[2]);
  Quaternion turn = AxisAngle({ 0.0, 0.0, 1.0 }, yaw);
  turn.Normalize();
  PartData part = model->Part;
  const double height = std::isnan(row.Z) ? 0.0 : row.Z;
  part.Translation = scale * Rotate(turn, part.Translation) + Vec3(row.X, row.Y, height);
  part.Rotation = turn * part.Rotation;
  part.Scale *= scale;
  part.OnGround = std::isnan(row.Z);
  part.Where = row.Where;
  part.Name = row.Name.empty() ? std::to_string(parts.size()) : row.Name;
  part.Classification = row.Classification < 0 ? part.Classification : row.Classification;
  part.Species = row.Species.empty() ? part.Species : row.Species;
  part.Tree = row.Tree;
  parts.push_back(std::move(part));
  return true;
}

} // namespace

//------------------------------------------------------------------------------
void AddTableParts(const PartTableData& table, std::vector<PartData>& parts, Messages& log)
{
  const RowParts rows(table, log);
  parts.reserve(parts.size() + table.Rows.size());
  bool isGood = true;
  for (std::size_t i = 0; isGood && i < table.Rows.size(); ++i)
  {
    isGood = rows.Add(i, parts);
  }
}

} // namespace helios
