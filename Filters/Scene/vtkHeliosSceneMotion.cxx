// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneMotion.h"

#include "heliosMovingParts.h"
#include "heliosStatus.h"

#include <vtkCellData.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkWeakPointer.h>

#include <cmath>
#include <map>

vtkStandardNewMacro(vtkHeliosSceneMotion);

struct vtkHeliosSceneMotion::Parts
{
  std::map<int, std::vector<helios::MotionSequence>> Motions;
  std::map<int, vtkIdType> Steps;
  std::vector<helios::MovingPart> Prepared;
  vtkWeakPointer<vtkPolyData> Scene; // the scene the parts were prepared for
  vtkMTimeType Time = 0;             // time of preparation; 0: not prepared
};

//------------------------------------------------------------------------------
vtkHeliosSceneMotion::vtkHeliosSceneMotion()
  : Moving(new Parts)
{
}

//------------------------------------------------------------------------------
vtkHeliosSceneMotion::~vtkHeliosSceneMotion() = default;

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::AddTranslation(int part, const double shift[3])
{
  helios::Motion motion;
  motion.Kind = helios::MotionKind::Translation;
  motion.Vector = helios::Vec3(shift);
  auto& sequences = this->Moving->Motions[part];
  sequences.resize(1);
  sequences[0].Motions.push_back(motion);
  this->SetMotion(part, std::vector<helios::MotionSequence>(sequences));
}

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::AddRotation(
  int part, const double axis[3], double angle, const double center[3], bool aboutCentroid)
{
  helios::Motion motion;
  motion.Kind = helios::MotionKind::Rotation;
  motion.Vector = helios::Vec3(axis);
  motion.Angle = angle;
  motion.Center = helios::Vec3(center);
  motion.IsSelf = aboutCentroid;
  auto& sequences = this->Moving->Motions[part];
  sequences.resize(1);
  sequences[0].Motions.push_back(motion);
  this->SetMotion(part, std::vector<helios::MotionSequence>(sequences));
}

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::SetMotion(int part, const std::vector<helios::MotionSequence>& sequences)
{
  this->Moving->Motions[part] = sequences;
  this->Moving->Time = 0;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::RemoveAllMotions()
{
  *this->Moving = Parts();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::SetStep(int part, vtkIdType step)
{
  if (step < 0)
  {
    vtkErrorMacro(<< "SetStep: step " << step << " of part " << part
                  << " is negative; a scene moves forwards only, from step 0");
    return;
  }
  if (step != this->GetStep(part))
  {
    this->Moving->Steps[part] = step;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSceneMotion::GetStep(int part) const
{
  const auto found = this->Moving->Steps.find(part);
  return found != this->Moving->Steps.end() ? found->second : 0;
}

//------------------------------------------------------------------------------
int vtkHeliosSceneMotion::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (this->TimeStep > 0.0)
  {
    const double range[2] = { 0.0, VTK_DOUBLE_MAX };
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  else
  {
    info->Remove(Pipeline::TIME_RANGE());
  }
  return 1;
}

//------------------------------------------------------------------------------
/// Prepares a scene unless it is unchanged.
bool vtkHeliosSceneMotion::Prepare(vtkPolyData* scene)
{
  Parts& parts = *this->Moving;
  if (parts.Scene == scene && scene->GetMTime() <= parts.Time)
  {
    return true;
  }
  parts.Scene = scene;
  parts.Time = 0;
  const helios::Status status = helios::FindMovingParts(scene, parts.Motions, parts.Prepared);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  parts.Time = scene->GetMTime();
  return true;
}

//------------------------------------------------------------------------------
int vtkHeliosSceneMotion::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!this->Moving->Motions.empty() && !this->Prepare(input))
  {
    return 0;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  const bool isTimed = this->TimeStep > 0.0 && info->Has(Pipeline::UPDATE_TIME_STEP());
  const double time = isTimed ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  output->ShallowCopy(input);
  std::vector<helios::MotionMap> maps;
  for (const helios::MovingPart& part : this->Moving->Prepared)
  {
    const vtkIdType step =
      isTimed ? helios::CountSteps(time, this->TimeStep) : this->GetStep(part.Id);
    maps.push_back(part.Motion.GetMap(step));
  }
  helios::MoveParts(this->Moving->Prepared, maps, output);
  if (isTimed)
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHeliosSceneMotion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  for (const auto& part : this->Moving->Motions)
  {
    os << indent << "Part " << part.first << ": " << part.second.size() << " sequences, step "
       << this->GetStep(part.first) << "\n";
  }
}
