// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A <filter> of a scene part: its type and its parameters.

#ifndef heliosXmlFilter_h
#define heliosXmlFilter_h

#include "heliosSurveyData.h"
#include "heliosXmlElement.h"
#include "heliosXmlKin.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace helios
{

/// One <filter>, read by the rule "filter:<type>".
class XmlFilter
{
public:
  explicit XmlFilter(const XmlElement& element);

  const std::string& GetType() const { return this->Type; }
  const XmlElement& GetElement() const { return this->Element; }
  std::string Where() const { return this->Element.Where(); }
  Messages& GetMessages() const { return this->Element.GetMessages(); }

  bool Has(const char* key) const { return this->Parameters.count(key) > 0; }
  const XmlElement& GetParameter(const char* key) const { return this->Parameters.at(key); }
  XmlValue GetValue(const char* key) const;

  /// Reads the value of a parameter, by its rule; false if missing or invalid, with the target
  /// unchanged.
  bool Read(const char* key, std::string& target) const;
  bool Read(const char* key, double& target) const;
  bool Read(const char* key, int& target) const;
  bool Read(const char* key, bool& target) const;
  bool Read(const char* key, Vec3& target) const;

  /// Reads all parameters that are stored in a struct.
  template <typename OwnerT>
  void ReadStored(OwnerT& owner) const
  {
    for (const XmlValueRule* rule : this->Rule->FindStored(typeid(OwnerT)))
    {
      if (this->Has(rule->Name))
      {
        ParseStored(
          this->GetValue(rule->Name), *rule, this->GetMessages(), rule->Store.Find(&owner));
      }
    }
  }

private:
  void AddParameter(const XmlElement& parameter);

  XmlElement Element;
  std::string Type;
  const XmlElementRule* Rule;
  std::map<std::string, XmlElement> Parameters;
};

/// Returns the supported filter types; loaders come first, in the order of Loader.
const std::vector<std::string>& GetFilterTypes();

/// Returns a <document> with a <scene> of one part, a mesh file; empty if the extension belongs to
/// no mesh.
std::string MakeMeshDocument(const std::string& fileName, const std::string& id);

/// Returns the loaders of these.
VTKHELIOSSCANNERSURVEY_EXPORT std::vector<std::string> GetLoaders();

/// Returns the name of a loader: "objloader".
VTKHELIOSSCANNERSURVEY_EXPORT const std::string& GetLoaderName(Loader type);

/// Returns the loader of a mesh by the extension of its file; none: not a mesh.
VTKHELIOSSCANNERSURVEY_EXPORT std::optional<Loader> FindLoader(const std::string& fileName);

/// Returns the extensions of meshes: ".obj, .tif, ...".
VTKHELIOSSCANNERSURVEY_EXPORT std::string GetMeshEndings();

} // namespace helios

#endif
