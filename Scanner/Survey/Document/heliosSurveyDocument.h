// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey as one document: elements and attributes of the dialect, whoever made them.

#ifndef heliosSurveyDocument_h
#define heliosSurveyDocument_h

#include "heliosAssets.h"
#include "heliosMessages.h"
#include "heliosStatus.h"
#include "heliosSurveyData.h"
#include "heliosXmlSurvey.h"

#include <memory>
#include <string>
#include <vector>

class vtkObject;

namespace helios
{

/// Owner of an attribute.
enum class SurveyItem
{
  Survey,
  Scene,
  Part,
  PartTable,
  Scanner,
  Platform,
  Leg
};

/// One item of a survey, counted from 0.
struct SurveyPlace
{
  SurveyItem Item;
  int Index = 0;
  int Channel = -1; ///< number of a scanner; negative: all
};

/**
 * A <survey> in a file or without one, and what it refers to in other files. Attributes are named by
 * their paths, see ElementPath. Elements of other files that are changed are copied into the
 * document first; their attributes keep their places in messages. Resolve() reads the document as
 * that of any file. Errors are reported for the owner. Indices count from 0; -1 is returned after an
 * error.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT SurveyDocument
{
public:
  /// Makes a survey without a file; names of files are also relative to the folder of a path.
  explicit SurveyDocument(vtkObject* owner, const std::string& path = "survey");
  SurveyDocument(const SurveyDocument&) = delete;
  void operator=(const SurveyDocument&) = delete;

  /// Sets the object that errors are reported for.
  void SetOwner(vtkObject* owner) { this->Owner = owner; }

  /// Loads a file, in place of what the document has. False if it is not a document; its other errors
  /// are those of Resolve(), too.
  bool Load(const std::string& fileName);
  bool Load(const std::string& fileName, const std::string& text); ///< loads that text as the file

  ///@{
  /// Whether a scene and trajectories are required, optional (of a survey without a file), or
  /// replaced by others.
  void SetNeeds(AssetNeed scene, AssetNeed trajectories);
  ///@}

  void SetAssetDirectories(const std::vector<std::string>& directories);
  const std::vector<std::string>& GetAssetDirectories() const;

  /// Reads the whole document; errors and warnings are reported for an owner, null: none.
  SurveyData Resolve(vtkObject* owner);

  /// Reads only the scene; messages are those of another log.
  SceneData ResolveScene(Messages& log);

  /// The last error; empty: none.
  const std::string& GetLastError() const { return this->Log.GetLastError(); }

  /// Whether the last call of Resolve() had an error.
  bool HasError() const { return this->IsBad; }

  /// Writes the document to a file that can be read with the same asset directories. Names are as given
  /// in the folder of the document, and from other folders as ReferTo() returns them.
  Status Write(const std::string& fileName);

  /// Sets the comment before the document.
  void SetComment(const std::string& text);

  ///@{
  /// Sets the text of an attribute; an empty one, or false for an element, removes it. Returns false
  /// after an error. Get returns what is given there or inherited, else the default, if it is a value.
  bool Set(const SurveyPlace& place, const std::string& path, const std::string& text);
  std::string Get(const SurveyPlace& place, const std::string& given);
  ///@}

  ///@{
  /// Add a scanner or platform with defaults, or from file.xml#id; a channel, as the first one is.
  int AddScanner(const std::string& id);
  int AddPlatform(const std::string& id);
  int AddFromFile(SurveyItem item, const std::string& reference);
  int AddChannel(int scanner);
  int GetNumberOfChannels(int scanner);
  ///@}

  ///@{
  /// Name what a survey consists of as given, file.xml#id or a mesh, which Resolve() finds; empty: not
  /// given. Add a leg with such a scanner and platform, and the settings of a template below its own.
  void SetSources(
    const std::string& scene, const std::string& platform, const std::string& scanner);
  void AddTemplate(const std::string& id, const LegSettings& settings);
  void AddLeg(const LegSettings& settings, const std::string& base);
  ///@}

  int AddLeg(int scanner, int platform);
  void RemoveLeg(int leg);
  void RemoveAllLegs();
  int GetNumberOfLegs();
  int GetNumberOf(SurveyItem item) const; ///< scanners, platforms or parts

  /// Moves a leg to another place among the legs.
  bool MoveLeg(int leg, int to);

  ///@{
  /// Add a part from a file by one of the loaders, or a table of parts; remove one or all.
  int AddPart(const std::string& loader, const std::string& file);
  int AddPartTable(const std::string& file);
  bool SetPartTableRows(int table, const std::string& text);
  bool RemovePart(int part);
  void RemoveAllParts();
  bool RotatePart(int part, const std::string& axis, double angle);
  ///@}

  ///@{
  /// Copies a scene into the document, file.xml#id or the first one of a file. Get or set its element as
  /// text, with whole paths of files; empty: none.
  bool UseScene(const std::string& reference);
  std::string GetSceneText() const;
  void SetSceneText(const std::string& text);
  ///@}

  /// Returns the text of a file with the scene, a scanner or a platform alone, and a comment; files are
  /// named from its folder. Empty after an error.
  std::string MakeFileText(
    const SurveyPlace& place, const std::string& comment, const std::string& fileName);

  /// The names of all attributes of an item that have one value.
  static std::vector<std::string> ListAttributes(SurveyItem item);

private:
  /// An item that was found.
  struct Found
  {
    XmlElement Element;
    std::string Where; ///< in messages
    explicit operator bool() const { return static_cast<bool>(this->Element); }
  };

  pugi::xml_node GetSurvey() const;
  XmlElement MakeElement(pugi::xml_node node) const { return { this->Own.get(), node }; }
  Found Find(const SurveyPlace& place);
  Found FindIn(const std::vector<XmlElement>& all, int index, const std::string& what);
  XmlElement GetChannel(const XmlElement& scanner, int channel) const;
  const std::vector<XmlElement>& GetLegs();
  std::vector<XmlElement> ListOwn(const char* tag) const;

  bool SetIn(const Found& found, SurveyItem item, const std::string& path, const std::string& text);
  bool SetScanner(const SurveyPlace& place, const std::string& path, const std::string& text);
  bool SetWhole(const Found& scanner, const std::string& path, const std::string& text);
  bool SetPlatform(const SurveyPlace& place, const std::string& path, const std::string& text);
  bool SetInterpolated(const SurveyPlace& place);
  bool FindFiles(std::string& text, const XmlValueRule* rule, const XmlValue& value);
  bool CheckLoader(const Found& found, const std::string& name);
  void RemoveSame(
    const Found& found, SurveyItem item, const XmlValueRule& rule, pugi::xml_node kept);
  std::vector<XmlElement> ListLayers(const Found& found, const SurveyPlace& place);
  void AddTemplates(const XmlElement& settings, std::vector<XmlElement>& layers);
  XmlElement GetBasePlatform(const XmlElement& platform);

  XmlElement AdoptItem(SurveyItem item, int index);
  void AdoptScene();
  void SpreadPart(const XmlElement& part, std::size_t index);
  std::vector<pugi::xml_attribute> FindReferences(const XmlElement& element);
  void AdoptOverrides(const std::string& path);
  void FoldOrigins();
  pugi::xml_node CopyHere(const XmlElement& element);
  void CopyPlaces(const XmlElement& from, pugi::xml_node to);
  std::string Refer(const XmlElement& element) const;
  std::string MakeId(const char* tag, const std::string& wanted) const;
  void Change(pugi::xml_node node, const std::string& where);
  pugi::xml_node AddBefore(const char* tag, const std::string& id, const std::string& where);
  Found MakeScene();
  bool Use(const std::shared_ptr<XmlDocument>& document);

  vtkObject* Owner;
  Messages Log;
  Assets Files;
  std::shared_ptr<XmlDocument> Own;
  SurveyElements Elements;
  std::vector<XmlElement> Legs;
  bool AreLegsListed = false;
  bool HasOrigins = false; ///< among the legs
  bool IsFile = false;
  bool IsBadFile = false;
  bool IsBad = false;
};

/**
 * Returns how a file in a folder refers to another: by the shortest path from the folder or one of the
 * asset directories other than the working directory, else by its absolute path.
 */
VTKHELIOSSCANNERSURVEY_EXPORT std::string ReferTo(const std::string& path,
  const std::string& folder, const std::vector<std::string>& assetDirectories);

///@{
/// Names all files in an element by their whole paths, as found from a document; or as a file in a
/// folder refers to them.
void FindFilesIn(pugi::xml_node node, const XmlDocument& from, Assets& files);
void ReferToFiles(pugi::xml_node node, const std::string& folder, const Assets& files);
///@}

///@{
/// Write a document as XML, or as YAML by the ending of the file: a tree as it is, or with its name and
/// the files that it names as the folder of the file has them.
Status WriteTree(pugi::xml_document& document, const std::string& fileName);
Status WriteDocument(XmlDocument& document, Assets& files, const std::string& fileName);
///@}

} // namespace helios

#endif
