// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damages structure and values of an XML file, reproducibly for a seed: the result is XML.

#ifndef heliosXmlMutation_h
#define heliosXmlMutation_h

#include <pugixml.hpp>

#include <cstdlib>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace helios
{

/// One to three of: elements removed, duplicated, moved or misspelt; attributes removed, exchanged,
/// moved elsewhere, misspelt; values that are edge cases, or in another unit.
class XmlMutator
{
public:
  explicit XmlMutator(unsigned seed)
    : Generator(seed)
  {
  }

  std::string operator()(const std::string& text)
  {
    pugi::xml_document document;
    document.load_string(text.c_str());
    for (std::size_t n = 1 + this->Below(3); n > 0; --n)
    {
      this->Damage(document.document_element());
    }
    std::ostringstream stream;
    document.save(stream, " ");
    return stream.str();
  }

private:
  std::size_t Below(std::size_t end) { return end > 0 ? this->Generator() % end : 0; }

  void Damage(const pugi::xml_node& root)
  {
    const std::size_t kind = this->Below(16);
    if (kind < 5)
    {
      this->DamageElement(kind, root);
    }
    else
    {
      this->DamageValue(kind, root);
    }
  }

  void DamageElement(std::size_t kind, const pugi::xml_node& root)
  {
    pugi::xml_node node = this->PickElement(root);
    const pugi::xml_node other = this->PickElement(root);
    if (node == root)
    {
      return;
    }
    switch (kind)
    {
      case 0:
        node.parent().remove_child(node);
        break;
      case 1:
        node.parent().insert_copy_after(node, node);
        break;
      case 2:
        pugi::xml_node(other).append_move(node); // null if it would be its own child
        break;
      case 3:
        pugi::xml_node(other).append_copy(node);
        break;
      default:
        node.set_name(this->Misspell(node.name()).c_str());
    }
  }

  void DamageValue(std::size_t kind, const pugi::xml_node& root)
  {
    pugi::xml_attribute value = this->PickAttribute(root);
    pugi::xml_attribute other = this->PickAttribute(root);
    const std::string text = value.value();
    switch (kind)
    {
      case 5:
        value.set_name(this->Misspell(value.name()).c_str());
        break;
      case 6:
        value.set_value(other.value());
        other.set_value(text.c_str());
        break;
      case 7:
        this->PickElement(root).append_copy(value);
        break;
      case 8:
      {
        pugi::xml_node owner = this->PickElement(root);
        owner.remove_attribute(owner.first_attribute());
        break;
      }
      case 9:
      case 10:
      case 11:
        value.set_value(this->ChangeUnit(text).c_str());
        break;
      default:
        value.set_value(this->PickTrap());
    }
  }

  /// Changes the unit or the sign of a number; other texts are kept.
  std::string ChangeUnit(const std::string& text)
  {
    static const double factors[] = { 1000.0, 0.001, 57.29577951308232, 0.017453292519943295, 1e6,
      1e-6, 1e9, 1e-9, -1.0, 100.0, 0.01 };
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    std::ostringstream stream;
    stream.precision(17);
    stream << number * factors[this->Below(std::size(factors))];
    return end == text.c_str() ? text + text : stream.str();
  }

  const char* PickTrap()
  {
    static const char* const traps[] = { "", " ", "nan", "inf", "-inf", "1e999", "-1e999", "0",
      "-0", "-1", "1e-300", "1e300", "-1e300", "1e18", "4294967296", "2147483647", "-2147483648",
      "99999999999999999999", "1,5", "1;2", "1;2;nan", "0x10", "true", "none", "#", "#s",
      "survey.xml#s", "/", "..", ".", "plane.obj", "*", "[", "EPSG:4326", "EPSG:0", "0.1", "1", "2",
      "64", "1e6" };
    return traps[this->Below(std::size(traps))];
  }

  std::string Misspell(std::string name)
  {
    const std::size_t at = this->Below(name.size());
    return this->Below(2) == 0 ? name.erase(at, 1) + "q" : name.insert(at, 1, name[at]);
  }

  static void Collect(const pugi::xml_node& node, std::vector<pugi::xml_node>& nodes)
  {
    if (node.type() == pugi::node_element)
    {
      nodes.push_back(node);
    }
    for (const pugi::xml_node child : node.children())
    {
      Collect(child, nodes);
    }
  }

  pugi::xml_node PickElement(const pugi::xml_node& root)
  {
    std::vector<pugi::xml_node> nodes;
    Collect(root, nodes);
    return nodes[this->Below(nodes.size())];
  }

  pugi::xml_attribute PickAttribute(const pugi::xml_node& root)
  {
    std::vector<pugi::xml_node> nodes;
    std::vector<pugi::xml_attribute> attributes;
    Collect(root, nodes);
    for (const pugi::xml_node& node : nodes)
    {
      attributes.insert(attributes.end(), node.attributes_begin(), node.attributes_end());
    }
    return attributes.empty() ? pugi::xml_attribute() : attributes[this->Below(attributes.size())];
  }

  std::mt19937 Generator; // equal numbers on all platforms
};

} // namespace helios

#endif
