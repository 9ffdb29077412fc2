// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHeightCache.h"

#include "heliosHeightField.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace helios
{

namespace
{

/// Arrays and times that a height field is made from.
struct Source
{
  vtkMTimeType Time = 0; ///< time of the heights
  std::vector<int> Size;
  std::vector<double> Transform;

  bool operator==(const Source& other) const
  {
    return this->Time == other.Time && this->Size == other.Size &&
      this->Transform == other.Transform;
  }
};

/// A height field, kept with the heights.
class KeptField : public vtkObject
{
public:
  static KeptField* New();
  vtkTypeMacro(KeptField, vtkObject);

  Source MadeOf;
  std::shared_ptr<const HeightField> Field;
};
vtkStandardNewMacro(KeptField);

vtkInformationObjectBaseKey* GetKey()
{
  static vtkInformationObjectBaseKey* key =
    vtkInformationObjectBaseKey::MakeKey("HEIGHT_FIELD", "vtkHelios");
  return key;
}

vtkDataArray* FindHeights(vtkImageData* raster)
{
  return raster ? raster->GetPointData()->GetArray(vtkHeliosArrayNames::Heights) : nullptr;
}

Source Describe(vtkImageData* raster)
{
  Source source;
  source.Time = FindHeights(raster)->GetMTime();
  source.Size.resize(3);
  raster->GetDimensions(source.Size.data());
  vtkDataArray* transform = raster->GetFieldData()->GetArray(vtkHeliosArrayNames::GeoTransform);
  for (vtkIdType i = 0; transform && i < transform->GetNumberOfTuples(); ++i)
  {
    source.Transform.push_back(transform->GetComponent(i, 0));
  }
  return source;
}

} // namespace

//------------------------------------------------------------------------------
Status GetHeightField(vtkImageData* raster, std::shared_ptr<const HeightField>& field)
{
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  vtkDataArray* heights = FindHeights(raster);
  auto* kept = heights && heights->HasInformation()
    ? KeptField::SafeDownCast(heights->GetInformation()->Get(GetKey()))
    : nullptr;
  if (kept && kept->MadeOf == Describe(raster))
  {
    field = kept->Field;
    return {};
  }
  auto made = std::make_shared<HeightField>();
  const Status status = made->Set(raster);
  field = made;
  if (status.IsOk())
  {
    made->ReleaseRaster(); // which holds it
    vtkNew<KeptField> keep;
    keep->MadeOf = Describe(raster);
    keep->Field = made;
    heights->GetInformation()->Set(GetKey(), keep);
  }
  return status;
}

} // namespace helios
