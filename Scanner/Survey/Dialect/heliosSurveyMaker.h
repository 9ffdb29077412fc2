// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Makes and changes a survey by the names of the dialect, without files of its own.

#ifndef heliosSurveyMaker_h
#define heliosSurveyMaker_h

#include "heliosAttributes.h"
#include "heliosMadeElements.h"
#include "heliosMessages.h"
#include "heliosSurveyData.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkObject;

namespace helios
{

class Assets;
class XmlDocument;
class XmlElement;

/// Errors are reported for the owner, which is modified by each change. Indices count from 0; -1 is
/// returned after an error.
class SurveyMaker
{
public:
  explicit SurveyMaker(vtkObject* owner);

  /// The survey, with its legs resolved.
  SurveyData& GetData();

  void SetAssetDirectories(const std::vector<std::string>& directories);
  const std::vector<std::string>& GetAssetDirectories() const { return this->AssetDirectories; }

  ///@{
  /// With defaults, or from file.xml#id.
  int AddScanner(const std::string& id);
  int AddPlatform(const std::string& id);
  int AddScannerFromFile(const std::string& reference);
  int AddPlatformFromFile(const std::string& reference);
  ///@}

  /// Adds a copy of a scanner's first channel as its last one; the scanner itself is the first.
  int AddChannel(int scanner);

  int AddLeg(int scanner, int platform);
  void RemoveLeg(int leg);
  void RemoveAllLegs();

  /// Adds a part from a file by one of the loaders.
  int AddPart(const std::string& loader, const std::string& file);
  void RemoveAllParts();

  ///@{
  /// Adds a table of parts, from a file if it is not empty; its values by path, and its rows as text.
  int AddPartTable(const std::string& file);
  bool SetPartTable(int table, const std::string& name, const std::string& value);
  std::string GetPartTable(int table, const std::string& name);
  bool SetPartTableRows(int table, const std::string& text);
  ///@}

  ///@{
  /// Something to change, with its place in messages; null after an error.
  LegSettings* FindLeg(int leg);
  PlatformData* FindPlatform(int platform);
  ScannerData* FindScanner(int scanner, int channel = 0);
  PartData* FindPart(int part);
  ///@}

  ///@{
  /// Set or get an attribute of what was found; null is ignored, its error is reported.
  template <typename WholeT>
  bool Set(WholeT* whole, const std::string& name, const std::string& value)
  {
    Messages log(this->Owner);
    if (!whole)
    {
      return false;
    }
    XmlValue given = this->MakeValue<WholeT>(name, value);
    const Attribute* attribute = FindStored<WholeT>(given.Name);
    if (!attribute && MadeElements::Keeps(*whole, name))
    {
      const bool isGood = this->Elements.Set(MadeElements::GetTag(*whole), given, log);
      isGood ? this->Change() : void();
      return isGood;
    }
    const bool isGood = this->FindFile(attribute, given, log) && SetAttribute(*whole, given, log);
    if (isGood)
    {
      Follow(*whole, given.Name, given.Where);
      this->FollowModel(*whole, given);
      this->Change();
    }
    return isGood;
  }

  template <typename WholeT>
  std::string Get(WholeT* whole, const std::string& name)
  {
    Messages log(this->Owner);
    if (!whole)
    {
      return {};
    }
    const XmlValue value = this->MakeValue<WholeT>(name, "");
    return !FindStored<WholeT>(value.Name) && MadeElements::Keeps(*whole, name)
      ? this->Elements.Get(MadeElements::GetTag(*whole), value, log)
      : GetAttribute(*whole, value, log);
  }
  ///@}

  ///@{
  /// Of the survey itself and of its scene.
  bool SetSurvey(const std::string& name, const std::string& value);
  std::string GetSurvey(const std::string& name);
  SceneData* FindScene();
  ///@}

  ///@{
  /// Those of a platform, with the type interpolated, which no file of a platform has.
  bool SetPlatform(int platform, const std::string& name, const std::string& value);
  std::string GetPlatform(int platform, const std::string& name);
  ///@}

  ///@{
  /// Those of a part, with the files of its loader.
  bool SetPart(int part, const std::string& name, const std::string& value);
  std::string GetPart(int part, const std::string& name);
  ///@}

  /// Rotates a part about x, y or z after its other rotations.
  bool RotatePart(int part, const std::string& axis, double angle);

  /// Reports all errors and warnings, unless nothing has changed since it was good.
  bool Check();

private:
  static void Follow(LegSettings& leg, const std::string& name, const std::string& where);
  static void Follow(ScannerData& scanner, const std::string& name, const std::string& where);
  static void Follow(PlatformData& platform, const std::string& name, const std::string& where);
  static void Follow(PartData& part, const std::string& name, const std::string& where);
  static void Follow(SceneData& scene, const std::string& name, const std::string& where);
  static void Follow(SurveyData&, const std::string&, const std::string&) {}

  /// A value of what was found last; the name of a stored attribute needs no index.
  template <typename WholeT>
  XmlValue MakeValue(const std::string& name, const std::string& value) const
  {
    const std::string simple = ElementTree::Simplify(name);
    return { FindStored<WholeT>(simple) ? simple : name, value, this->Where };
  }

  bool FindFile(const Attribute* attribute, XmlValue& value, Messages& log);
  template <typename WholeT>
  void FollowModel(WholeT&, const XmlValue&)
  {
  }
  void FollowModel(ScannerData& scanner, const XmlValue& value);
  void FollowModel(PlatformData& platform, const XmlValue& value);
  ModelData MakeModel(const XmlValue& value) const;
  bool SetFiles(PartData& part, const XmlValue& value);
  static std::unique_ptr<XmlDocument> MakeNowhere(Messages& log);
  void Change();
  void Resolve();
  void CheckAll(Messages& log);
  template <typename ReadT>
  bool ReadFromFile(const char* tag, const std::string& reference, ReadT read);
  template <typename DataT>
  DataT* Find(std::vector<DataT>& all, int index, const char* what, std::size_t count = SIZE_MAX);

  vtkObject* Owner;
  SurveyData Data;
  MadeElements Elements;
  std::vector<std::string> AssetDirectories;
  std::string Where; // of what was found last
  bool IsResolved = true;
  bool IsChecked = true; // as far as it has legs
};

} // namespace helios

#endif
