// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointXMLReader.h"

#include "heliosVtkXmlReading.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>

vtkStandardNewMacro(vtkHeliosPointXMLReader);

namespace
{

/// Returns whether the cell offsets increase, and the points exist.
bool IsValid(vtkCellArray* cells, vtkIdType points)
{
  if (!cells->IsValid())
  {
    return false;
  }
  if (cells->GetNumberOfConnectivityIds() == 0)
  {
    return true;
  }
  double range[2];
  cells->GetConnectivityArray()->GetRange(range, 0);
  return range[0] >= 0.0 && range[1] < static_cast<double>(points);
}

bool HasValidCells(vtkPolyData* cloud)
{
  const vtkIdType points = cloud->GetNumberOfPoints();
  vtkCellArray* all[] = { cloud->GetVerts(), cloud->GetLines(), cloud->GetStrips(),
    cloud->GetPolys() };
  return std::all_of(std::begin(all), std::end(all),
    [points](vtkCellArray* cells) { return !cells || IsValid(cells, points); });
}

/// Returns whether the point arrays agree in name, type and components.
bool HasSameArrays(vtkPolyData* one, vtkPolyData* other)
{
  vtkPointData* ours = one->GetPointData();
  vtkPointData* theirs = other->GetPointData();
  bool areSame = ours->GetNumberOfArrays() == theirs->GetNumberOfArrays();
  for (int i = 0; areSame && i < ours->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = ours->GetAbstractArray(i);
    vtkAbstractArray* same = theirs->GetAbstractArray(array->GetName());
    areSame = same && same->GetDataType() == array->GetDataType() &&
      same->GetNumberOfComponents() == array->GetNumberOfComponents();
  }
  return areSame;
}

vtkSmartPointer<vtkPolyData> ReadPiece(const std::string& name, std::string& problem)
{
  auto cloud = helios::ReadVtkXml<vtkXMLPolyDataReader, vtkPolyData>(name, "PolyData", problem);
  if (cloud && !HasValidCells(cloud))
  {
    problem = "has cells with points that do not exist; write the file again";
    return nullptr;
  }
  return cloud;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosPointXMLReader::vtkHeliosPointXMLReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosPointXMLReader::~vtkHeliosPointXMLReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
bool vtkHeliosPointXMLReader::FindPieces()
{
  this->Pieces.clear();
  this->NumberOfPoints = 0;
  const std::string name = this->FileName ? this->FileName : "";
  helios::VtkXmlFile file;
  if (name.empty() || !file.Open(name, "PolyData"))
  {
    vtkErrorMacro(<< (name.empty() ? "FileName is not set; give a file of points, .vtp or .pvtp"
                                   : name + ": " + file.GetProblem()));
    return false;
  }
  if (file.GetKind() == helios::VtkXmlFile::Kind::Index)
  {
    this->Pieces = file.GetPieces();
    return true;
  }
  this->Pieces.push_back(name);
  this->NumberOfPoints = file.GetNumberOfRecords();
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosPointXMLReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->FindPieces();
}

//------------------------------------------------------------------------------
int vtkHeliosPointXMLReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  const bool isPiece = outInfo->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) != 0;
  const auto count =
    isPiece ? std::max<vtkIdType>(1, outInfo->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) : 1;
  const vtkIdType piece = isPiece ? outInfo->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0;
  if (piece < 0 || piece >= count)
  {
    return 1;
  }
  const vtkIdType first = this->GetNumberOfPieces() * piece / count;
  const vtkIdType last = this->GetNumberOfPieces() * (piece + 1) / count;
  vtkNew<vtkAppendPolyData> all;
  vtkSmartPointer<vtkPolyData> cloud = vtkSmartPointer<vtkPolyData>::New();
  for (vtkIdType i = first; i < last; ++i)
  {
    const std::string& name = this->Pieces[static_cast<std::size_t>(i)];
    std::string problem;
    const vtkSmartPointer<vtkPolyData> read = ReadPiece(name, problem);
    if (read && i > first && !HasSameArrays(read, cloud))
    {
      problem = "has other arrays than the pieces before it; are they of one run?";
    }
    if (!problem.empty())
    {
      vtkErrorMacro(<< name << ": " << problem);
      return 0;
    }
    cloud = i > first ? cloud : read;
    all->AddInputData(read);
    this->UpdateProgress(static_cast<double>(i + 1 - first) / static_cast<double>(last - first));
  }
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(cloud);
  if (last - first > 1)
  {
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    all->Update();
    whole->ShallowCopy(all->GetOutput());
    whole->GetFieldData()->ShallowCopy(cloud->GetFieldData());
  }
  vtkPolyData::GetData(outputVector)->ShallowCopy(whole);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosPointXMLReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "NumberOfPieces: " << this->GetNumberOfPieces() << "\n"
     << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
}
