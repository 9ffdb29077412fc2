// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGltfAccessor.h"

#include "heliosGltfDocument.h"
#include "heliosMemoryCheck.h"
#include "heliosSceneMesh.h"
#include "heliosTextFile.h"

#include <json/json.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

namespace helios
{

namespace
{

/// A component type, by its number in documents.
struct NumberKind
{
  std::int64_t Code;
  std::int64_t Size; // [bytes]
  double Largest;    // largest value of normalized integers; 0: floats
  double (*Read)(const char* bytes);
};

/// Returns a number in little-endian order.
template <typename T>
double ReadNumber(const char* bytes)
{
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
  {
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  if constexpr (sizeof(T) == 4)
  {
    T value{};
    std::memcpy(&value, &bits, sizeof(value));
    return static_cast<double>(value);
  }
  else
  {
    return static_cast<double>(static_cast<T>(bits));
  }
}

constexpr NumberKind Kinds[] = { { 5120, 1, 127.0, ReadNumber<std::int8_t> },
  { 5121, 1, 255.0, ReadNumber<std::uint8_t> }, { 5122, 2, 32767.0, ReadNumber<std::int16_t> },
  { 5123, 2, 65535.0, ReadNumber<std::uint16_t> }, { 5125, 4, 0.0, ReadNumber<std::uint32_t> },
  { 5126, 4, 0.0, ReadNumber<float> } };

int GetComponents(const std::string& type)
{
  return type == "SCALAR" ? 1 : type == "MAT4" ? 16 : type.back() - '0';
}

class AccessorReader
{
public:
  AccessorReader(GltfDocument& document, std::int64_t index)
    : Document(document)
    , Accessor(document.GetElement("accessors", index))
    , Path(ElementPath("accessors", index))
  {
  }

  Status Read(const std::string& type, GltfNumbers& numbers)
  {
    Status status = this->ReadType(type, numbers.Components);
    status = status.IsOk() ? this->CheckCount() : status;
    if (!status.IsOk())
    {
      return status;
    }
    numbers.Values.assign(
      static_cast<std::size_t>(this->Count) * static_cast<std::size_t>(numbers.Components), 0.0);
    if (!GetMember(this->Accessor, "bufferView").isNull())
    {
      status = this->ReadElements(
        this->Accessor, this->Path, *this->Kind, numbers.Components, this->Count, numbers.Values);
    }
    const Json::Value& sparse = GetMember(this->Accessor, "sparse");
    status = status.IsOk() && !sparse.isNull() ? this->ReadSparse(sparse, numbers) : status;
    this->Normalize(numbers.Values);
    return status;
  }

private:
  /// Finds the kind of the numbers in an accessor, or in the indices of a sparse one.
  Status FindKind(const Json::Value& object, const std::string& path, const NumberKind*& kind) const
  {
    const Json::Value& code = GetMember(object, "componentType");
    const auto* found = std::find_if(std::begin(Kinds), std::end(Kinds),
      [&code](const NumberKind& each) { return code.isInt64() && code.asInt64() == each.Code; });
    kind = found;
    return found == std::end(Kinds)
      ? this->Document.Fail(path + ".componentType",
          "is " + Describe(code) + ", not one of 5120, 5121, 5122, 5123, 5125, 5126; correct it")
      : Status();
  }

  Status ReadType(const std::string& expected, int& components)
  {
    const std::string type = GetText(this->Accessor, "type");
    components = GetComponents(expected);
    return type == expected
      ? this->FindKind(this->Accessor, this->Path, this->Kind)
      : this->Document.Fail(this->Path + ".type",
          "is " + Quote(type) + ", and " + Quote(expected) + " is needed here; correct it");
  }

  /// Checks the number of elements: without a view, nothing else limits it.
  Status CheckCount()
  {
    Status status = this->Document.ReadWhole(this->Accessor, "count", this->Path, 0, this->Count);
    if (status.IsOk() && this->Count > MaximumCorners)
    {
      return this->Document.Fail(this->Path + ".count",
        "is " + std::to_string(this->Count) + ", above " + std::to_string(MaximumCorners) +
          "; split the file into several scene parts");
    }
    status = status.IsOk()
      ? CheckMemory("elements", static_cast<double>(this->Count), 4.0 * sizeof(double))
      : status;
    return status.IsOk() ? status : this->Document.Fail(this->Path + ".count", status.Message());
  }

  /// Reads elements from the view of an accessor, or of a part of a sparse one.
  Status ReadElements(const Json::Value& object, const std::string& path, const NumberKind& kind,
    std::int64_t components, std::int64_t count, std::vector<double>& values) const
  {
    GltfBytes view;
    std::int64_t begin = 0;
    Status status =
      this->Document.ReadView(GetMember(object, "bufferView"), path + ".bufferView", view);
    status =
      status.IsOk() ? this->Document.ReadWhole(object, "byteOffset", path, 0, begin) : status;
    if (!status.IsOk())
    {
      return status;
    }
    const std::int64_t size = kind.Size * components;
    const std::int64_t stride = view.Stride > 0 ? view.Stride : size;
    const auto present = static_cast<std::int64_t>(view.Bytes.size());
    const bool fits = count == 0 ||
      (stride >= size && begin <= present - size && (present - size - begin) / stride >= count - 1);
    if (!fits)
    {
      return this->Document.Fail(path,
        std::to_string(count) + " elements of " + std::to_string(size) + " bytes, every " +
          std::to_string(stride) + " from byte " + std::to_string(begin) +
          ", do not fit into the " + std::to_string(present) +
          " bytes of their bufferView; write the file again");
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      const char* element = view.Bytes.data() + begin + i * stride;
      for (std::int64_t k = 0; k < components; ++k)
      {
        values[static_cast<std::size_t>(i * components + k)] = kind.Read(element + k * kind.Size);
      }
    }
    return {};
  }

  /// Replaces the elements that a sparse accessor lists.
  Status ReadSparse(const Json::Value& sparse, GltfNumbers& numbers) const
  {
    const std::string path = this->Path + ".sparse";
    std::int64_t count = 0;
    Status status = this->Document.ReadWhole(sparse, "count", path, 0, count);
    if (status.IsOk() && count > this->Count)
    {
      return this->Document.Fail(path + ".count",
        "is " + std::to_string(count) + ", and the accessor has " + std::to_string(this->Count) +
          " elements; correct it");
    }
    const Json::Value& list = GetMember(sparse, "indices");
    const NumberKind* kind = nullptr;
    const auto size = static_cast<std::size_t>(status.IsOk() ? count : 0);
    const auto components = static_cast<std::size_t>(numbers.Components);
    std::vector<double> indices(size);
    std::vector<double> values(size * components);
    status = status.IsOk() ? this->FindKind(list, path + ".indices", kind) : status;
    status = status.IsOk() ? this->ReadElements(list, path + ".indices", *kind, 1, count, indices)
                           : status;
    status = status.IsOk() ? this->ReadElements(GetMember(sparse, "values"), path + ".values",
                               *this->Kind, numbers.Components, count, values)
                           : status;
    for (std::size_t i = 0; status.IsOk() && i < size; ++i)
    {
      if (!(indices[i] >= 0.0 && indices[i] < static_cast<double>(this->Count)))
      {
        return this->Document.Fail(path + ".indices",
          "element " + std::to_string(i) + " is not an index below " + std::to_string(this->Count) +
            "; correct it");
      }
      std::copy_n(values.data() + i * components, components,
        numbers.Values.data() + static_cast<std::size_t>(indices[i]) * components);
    }
    return status;
  }

  void Normalize(std::vector<double>& values) const
  {
    if (GetMember(this->Accessor, "normalized").isBool() &&
      GetMember(this->Accessor, "normalized").asBool() && this->Kind->Largest > 0.0)
    {
      std::transform(values.begin(), values.end(), values.begin(),
        [this](double x) { return std::max(x / this->Kind->Largest, -1.0); });
    }
  }

  GltfDocument& Document;
  const Json::Value& Accessor;
  std::string Path;
  const NumberKind* Kind = nullptr;
  std::int64_t Count = 0;
};

} // namespace

//------------------------------------------------------------------------------
Status ReadAccessor(GltfDocument& document, const Json::Value& value, const std::string& where,
  const std::string& type, GltfNumbers& numbers)
{
  std::int64_t index = 0;
  const Status status = document.FindIndex("accessors", value, where, index);
  return status.IsOk() ? AccessorReader(document, index).Read(type, numbers) : status;
}

} // namespace helios
