// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosImageReader.h"

#include "heliosImage.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

vtkStandardNewMacro(vtkHeliosImageReader);

namespace
{

constexpr int Components = 3;

helios::Status CheckName(const char* name)
{
  return name && *name
    ? helios::Status()
    : helios::Status::Error("FileName is not set; give an image with SetFileName");
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosImageReader::vtkHeliosImageReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHeliosImageReader::~vtkHeliosImageReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkHeliosImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  helios::ImageHeader header;
  helios::Status status = CheckName(this->FileName);
  if (status.IsOk())
  {
    status = helios::ReadImageHeader({ this->FileName }, header);
  }
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  const int extent[6] = { 0, header.Width - 1, 0, header.Height - 1, 0, 0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, Components);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  helios::Image image;
  const helios::Status status = helios::ReadImage({ this->FileName }, image);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return 0;
  }
  if (!image.Header.Warning.empty())
  {
    vtkWarningMacro(<< image.Header.Warning);
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(vtkHeliosArrayNames::RGB);
  colors->SetNumberOfComponents(Components);
  const auto count = static_cast<vtkIdType>(image.Header.Width) * image.Header.Height;
  colors->SetArray(
    image.Pixels.release(), Components * count, 0, vtkUnsignedCharArray::VTK_DATA_ARRAY_FREE);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->SetExtent(0, image.Header.Width - 1, 0, image.Header.Height - 1, 0, 0);
  output->GetPointData()->SetScalars(colors);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
