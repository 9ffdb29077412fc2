// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTexture.h"

#include <vtkBMPReader.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNMReader.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace helios
{

namespace
{

/// A number of pixels, repeated: [0, count).
int Repeat(double position, int count)
{
  const double turns = std::floor(position / count);
  return std::min(count - 1, static_cast<int>(position - turns * count));
}

/// A reader of one of the formats that textures have; null: the file has none of them.
vtkSmartPointer<vtkImageReader2> MakeReader(const std::string& path)
{
  const vtkSmartPointer<vtkImageReader2> readers[] = { vtkSmartPointer<vtkPNGReader>::New(),
    vtkSmartPointer<vtkJPEGReader>::New(), vtkSmartPointer<vtkTIFFReader>::New(),
    vtkSmartPointer<vtkBMPReader>::New(), vtkSmartPointer<vtkPNMReader>::New() };
  const auto found = std::find_if(std::begin(readers), std::end(readers),
    [&path](const auto& reader) { return reader->CanReadFile(path.c_str()) != 0; });
  return found == std::end(readers) ? nullptr : *found;
}

/// Reads an image; null if it cannot be read. Messages of the reader are dropped.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& path)
{
  const vtkSmartPointer<vtkImageReader2> reader = MakeReader(path);
  if (!reader)
  {
    return nullptr;
  }
  bool hasFailed = false;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&hasFailed);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* failed, void*) { *static_cast<bool*>(failed) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listener);
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  return hasFailed || image->GetNumberOfPoints() == 0 ? nullptr : image;
}

} // namespace

//------------------------------------------------------------------------------
Status Texture::Read(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::exists(path, error))
  {
    return Status::Error("texture " + path + " does not exist; give it, or remove map_Kd");
  }
  const vtkSmartPointer<vtkImageData> image = ReadImage(path);
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  const int type = values ? values->GetDataType() : VTK_VOID;
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT)
  {
    return Status::Error("texture " + path +
      " is no image of 8 or 16 bits that can be read; give PNG, JPEG, TIFF, BMP or PNM");
  }
  int size[3];
  image->GetDimensions(size);
  this->Width = size[0];
  this->Height = size[1];
  const double scale = 255.0 / values->GetDataTypeMax();
  const bool isGrey = values->GetNumberOfComponents() < 3;
  this->Pixels.clear();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = values->GetComponent(i, isGrey ? 0 : c);
      this->Pixels.push_back(static_cast<unsigned char>(std::lround(scale * value)));
    }
  }
  return {};
}

//------------------------------------------------------------------------------
const unsigned char* Texture::GetPixel(int column, int row) const
{
  const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Width) +
    static_cast<std::size_t>(column);
  return this->Pixels.data() + 3 * pixel;
}

//------------------------------------------------------------------------------
Rgb Texture::Get(double u, double v) const
{
  const double x = u * this->Width - 0.5;
  const double y = v * this->Height - 0.5;
  const double fx = x - std::floor(x);
  const double fy = y - std::floor(y);
  const int columns[2] = { Repeat(std::floor(x), this->Width),
    Repeat(std::floor(x) + 1.0, this->Width) };
  const int rows[2] = { Repeat(std::floor(y), this->Height),
    Repeat(std::floor(y) + 1.0, this->Height) };
  Rgb color{};
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const unsigned char* pixel = this->GetPixel(columns[i], rows[j]);
      const double weight = (i == 0 ? 1.0 - fx : fx) * (j == 0 ? 1.0 - fy : fy);
      for (std::size_t c = 0; c < 3; ++c)
      {
        color[c] += weight * pixel[c] / 255.0;
      }
    }
  }
  return color;
}

//------------------------------------------------------------------------------
std::shared_ptr<const Texture> TextureStore::Get(
  const std::string& path, std::vector<std::string>& faults)
{
  const auto [place, isNew] = this->Known.try_emplace(path);
  if (isNew)
  {
    const auto texture = std::make_shared<Texture>();
    const Status status = texture->Read(path);
    if (status.IsOk())
    {
      place->second = texture;
    }
    else
    {
      faults.push_back(status.Message());
    }
  }
  return place->second;
}

} // namespace helios
