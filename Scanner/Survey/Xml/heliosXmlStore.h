// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the value of an attribute is stored in a struct.

#ifndef heliosXmlStore_h
#define heliosXmlStore_h

#include "heliosPose.h"

#include <vtkType.h>

#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <variant>
#include <vector>

namespace helios
{

/// An enumeration, as the index of its word in the choices of an attribute.
struct XmlEnumeration
{
  void* Place = nullptr;
  int (*Get)(const void*) = nullptr;
  void (*Set)(void*, int) = nullptr;
};

class Messages;
struct XmlValue;

/// A value with functions of its own, such as a shape or its file; an empty text is the default.
struct XmlAccess
{
  void* Place = nullptr;
  bool (*Set)(void*, const XmlValue&, Messages&) = nullptr;
  std::string (*Get)(const void*) = nullptr;
};

/// The place of one value.
/// A vtkIdType is a seed.
using XmlPlace = std::variant<std::monostate, double*, int*, bool*, std::string*, vtkIdType*,
  std::vector<double>*, Vec3*, XmlEnumeration, XmlAccess>;

/// Finds the place of a value in a struct of one type.
struct XmlStore
{
  const std::type_info* Owner = nullptr; ///< the type of the struct; null: not stored
  XmlPlace (*Find)(void* owner) = nullptr;
  XmlPlace (*FindDefault)() = nullptr;            ///< in a struct that no one changes
  std::shared_ptr<void> (*MakeOwner)() = nullptr; ///< a struct with the defaults
};

namespace store
{

template <typename ValueT>
XmlPlace MakePlace(ValueT& value)
{
  if constexpr (std::is_enum_v<ValueT>)
  {
    return XmlEnumeration{ &value,
      [](const void* place) { return static_cast<int>(*static_cast<const ValueT*>(place)); },
      [](void* place, int index) { *static_cast<ValueT*>(place) = static_cast<ValueT>(index); } };
  }
  else
  {
    return &value;
  }
}

/// Follows members, and indices of arrays.
template <auto Step, auto... Rest, typename OwnerT>
auto& Follow(OwnerT& from)
{
  if constexpr (sizeof...(Rest) > 0)
  {
    return Follow<Rest...>(Follow<Step>(from));
  }
  else if constexpr (std::is_member_object_pointer_v<decltype(Step)>)
  {
    return from.*Step;
  }
  else
  {
    return from[Step];
  }
}

template <typename OwnerT, typename ValueT>
OwnerT OwnerOf(ValueT OwnerT::*);

/// Returns a struct with the defaults of its type.
template <typename OwnerT>
OwnerT& GetUnchanged()
{
  static OwnerT unchanged;
  return unchanged;
}

template <typename OwnerT>
std::shared_ptr<void> MakeOwner()
{
  return std::make_shared<OwnerT>();
}

template <auto First>
using Owner = decltype(OwnerOf(First));

template <auto First, auto... Rest>
XmlPlace Find(void* owner)
{
  return MakePlace(Follow<First, Rest...>(*static_cast<Owner<First>*>(owner)));
}

template <auto First, auto... Rest>
XmlPlace FindDefault()
{
  return Find<First, Rest...>(&GetUnchanged<Owner<First>>());
}

/// Finds the access to a member whose value is set and got by functions.
template <auto Set, auto Get, auto First>
XmlPlace FindAccess(void* owner)
{
  auto& member = Follow<First>(*static_cast<Owner<First>*>(owner));
  using MemberT = std::remove_reference_t<decltype(member)>;
  return XmlAccess{ &member,
    [](void* place, const XmlValue& value, Messages& log)
    { return Set(*static_cast<MemberT*>(place), value, log); },
    [](const void* place) { return Get(*static_cast<const MemberT*>(place)); } };
}

template <auto Set, auto Get, auto First>
XmlPlace FindDefaultAccess()
{
  return FindAccess<Set, Get, First>(&GetUnchanged<Owner<First>>());
}

} // namespace store

/// Returns the store at a chain of members and indices, as in MakeStore<&ScannerData::Prisms, 0,
/// &PrismData::WedgeAngle>().
template <auto First, auto... Rest>
XmlStore MakeStore()
{
  return { &typeid(store::Owner<First>), store::Find<First, Rest...>,
    store::FindDefault<First, Rest...>, store::MakeOwner<store::Owner<First>> };
}

/// Returns the store of a member with functions of its own: Set(member, value, log) and
/// Get(member).
template <auto Set, auto Get, auto First>
XmlStore MakeAccess()
{
  return { &typeid(store::Owner<First>), store::FindAccess<Set, Get, First>,
    store::FindDefaultAccess<Set, Get, First>, store::MakeOwner<store::Owner<First>> };
}

} // namespace helios

#endif
