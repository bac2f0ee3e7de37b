#include "PlyElements.h"

#include "Failure.h"
#include "TextLines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace
{
enum class Format
{
  Ascii,
  LittleEndian,
  BigEndian
};

PlyType ParseType(std::string_view name)
{
  const struct
  {
    const char* Name;
    const char* Other;
    PlyType Value;
  } types[] = { { "char", "int8", { 1, false, VTK_SIGNED_CHAR } },
    { "uchar", "uint8", { 1, false, VTK_UNSIGNED_CHAR } },
    { "short", "int16", { 2, false, VTK_SHORT } },
    { "ushort", "uint16", { 2, false, VTK_UNSIGNED_SHORT } },
    { "int", "int32", { 4, false, VTK_INT } }, { "uint", "uint32", { 4, false, VTK_UNSIGNED_INT } },
    { "float", "float32", { 4, true, VTK_FLOAT } },
    { "double", "float64", { 8, true, VTK_DOUBLE } } };
  for (const auto& known : types)
  {
    if (name == known.Name || name == known.Other)
    {
      return known.Value;
    }
  }
  MalformedPly("unknown type '" + std::string(name.substr(0, 40)) + "'");
}

PlyProperty ParseProperty(TextLines& lines)
{
  PlyProperty property;
  std::string_view type = lines.Word();
  if (type == "list")
  {
    property.IsList = true;
    property.Offsets = { 0 };
    property.Length = ParseType(lines.Word());
    type = lines.Word();
  }
  property.Item = ParseType(type);
  property.Name = lines.Word();
  if (property.Name.empty())
  {
    MalformedPly("a property has no name");
  }
  return property;
}

PlyElement ParseElement(TextLines& lines)
{
  PlyElement element;
  element.Name = lines.Word();
  long long count = -1;
  if (!ParseInteger(lines.Word(), count) || count < 0 || count > std::numeric_limits<int>::max())
  {
    MalformedPly("an element has no valid count");
  }
  element.Count = count;
  return element;
}

Format ParseFormat(std::string_view name)
{
  if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
  {
    MalformedPly("unknown format '" + std::string(name.substr(0, 40)) + "'");
  }
  return name == "ascii"             ? Format::Ascii
    : name == "binary_little_endian" ? Format::LittleEndian
                                     : Format::BigEndian;
}

Format ParseHeader(TextLines& lines, std::vector<PlyElement>& elements)
{
  std::string_view format;
  if (!lines.Next() || lines.Word() != "ply")
  {
    MalformedPly("it does not start with 'ply'");
  }
  while (lines.Next())
  {
    const std::string_view keyword = lines.Word();
    if (keyword == "end_header")
    {
      return format.empty() ? throw Failure("malformed PLY file, the header names no format")
                            : ParseFormat(format);
    }
    if (keyword == "format")
    {
      format = lines.Word();
    }
    else if (keyword == "element")
    {
      elements.push_back(ParseElement(lines));
    }
    else if (keyword == "property")
    {
      if (elements.empty())
      {
        MalformedPly("a property comes before any element");
      }
      elements.back().Properties.push_back(ParseProperty(lines));
    }
    else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
    {
      MalformedPly("unknown word in the header: '" + std::string(keyword.substr(0, 40)) + "'");
    }
  }
  MalformedPly("it ends in its header");
}

template <typename T>
double As(const char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double Decode(const PlyType& type, const char* bytes)
{
  switch (type.VtkType)
  {
    case VTK_SIGNED_CHAR:
      return As<std::int8_t>(bytes);
    case VTK_UNSIGNED_CHAR:
      return As<std::uint8_t>(bytes);
    case VTK_SHORT:
      return As<std::int16_t>(bytes);
    case VTK_UNSIGNED_SHORT:
      return As<std::uint16_t>(bytes);
    case VTK_INT:
      return As<std::int32_t>(bytes);
    case VTK_UNSIGNED_INT:
      return As<std::uint32_t>(bytes);
    case VTK_FLOAT:
      return As<float>(bytes);
    default:
      return As<double>(bytes);
  }
}

bool IsLittleEndian()
{
  const std::uint16_t one = 1;
  return As<std::uint8_t>(reinterpret_cast<const char*>(&one)) == 1.0;
}

/** The numbers of the body, one after the other; throws where they end too early. */
class Body
{
public:
  Body(std::string_view bytes, Format format)
    : Bytes(bytes)
    , Lines(bytes)
    , IsText(format == Format::Ascii)
    , Swaps((format == Format::LittleEndian) != IsLittleEndian())
  {
  }

  /** Text has a line for each row of an element. */
  void BeginRow() { this->IsAtStart = true; }

  double ReadNumber(const PlyType& type)
  {
    return this->IsText ? this->ReadText() : this->ReadBinary(type);
  }

  /** The most numbers that can follow. */
  std::size_t GetRoom() const { return this->Bytes.size(); }

private:
  double ReadText()
  {
    std::string_view word = this->IsAtStart ? std::string_view() : this->Lines.Word();
    while (this->IsAtStart && word.empty()) // empty lines do not count
    {
      if (!this->Lines.Next())
      {
        MalformedPly("it ends in its body");
      }
      word = this->Lines.Word();
    }
    this->IsAtStart = false;
    double value = 0.0;
    if (!ParseNumber(word, value))
    {
      MalformedPly(this->Lines.Where() + " of its body has " +
        (word.empty() ? "too few numbers" : "'" + std::string(word.substr(0, 40)) + "'"));
    }
    return value;
  }

  double ReadBinary(const PlyType& type)
  {
    const auto size = static_cast<std::size_t>(type.Size);
    if (this->Bytes.size() < size)
    {
      MalformedPly("it ends in its body");
    }
    char bytes[8];
    std::copy_n(this->Bytes.begin(), size, bytes);
    if (this->Swaps)
    {
      std::reverse(bytes, bytes + size);
    }
    this->Bytes.remove_prefix(size);
    return Decode(type, bytes);
  }

  std::string_view Bytes;
  TextLines Lines;
  bool IsText;
  bool Swaps;
  bool IsAtStart = false;
};

void ReadRow(Body& body, PlyElement& element)
{
  body.BeginRow();
  for (PlyProperty& property : element.Properties)
  {
    const double length = property.IsList ? body.ReadNumber(property.Length) : 1;
    if (!(length >= 0 && length <= static_cast<double>(body.GetRoom())) ||
      length != std::floor(length))
    {
      MalformedPly("a list is too long or too short");
    }
    for (double i = 0; i < length; ++i)
    {
      property.Values.push_back(body.ReadNumber(property.Item));
    }
    if (property.IsList)
    {
      property.Offsets.push_back(property.Values.size());
    }
  }
}
} // namespace

const PlyProperty* PlyElement::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Properties.begin(), this->Properties.end(),
    [&name](const PlyProperty& property) { return property.Name == name; });
  return found != this->Properties.end() ? &*found : nullptr;
}

void MalformedPly(const std::string& what)
{
  throw Failure("malformed PLY file, " + what);
}

std::vector<PlyElement> ReadPlyElements(const std::string& bytes)
{
  std::vector<PlyElement> elements;
  TextLines lines(bytes);
  const Format format = ParseHeader(lines, elements);
  Body body(std::string_view(bytes).substr(std::min(lines.GetPosition(), bytes.size())), format);
  for (PlyElement& element : elements)
  {
    for (PlyProperty& property : element.Properties)
    {
      property.Values.reserve(std::min(static_cast<std::size_t>(element.Count), bytes.size()));
    }
    for (vtkIdType row = 0; row < element.Count && !element.Properties.empty(); ++row)
    {
      ReadRow(body, element);
    }
  }
  return elements;
}
