#include "PlyCheck.h"

#include "Failure.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
struct Type
{
  int Size = 0; // bytes
  bool Float = false;
  bool Signed = false;
};

struct Property
{
  std::string Name;
  bool List = false;
  Type Length; // of a list
  Type Item;
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

enum class Format
{
  Ascii,
  LittleEndian,
  BigEndian
};

struct Header
{
  Format BodyFormat = Format::Ascii;
  std::vector<Element> Elements;
};

[[noreturn]] void Malformed(const std::string& what)
{
  throw Failure("malformed PLY file, " + what);
}

Type ParseType(const std::string& name)
{
  const struct
  {
    const char* Name;
    Type Value;
  } types[] = { { "char", { 1, false, true } }, { "int8", { 1, false, true } },
    { "uchar", { 1, false, false } }, { "uint8", { 1, false, false } },
    { "short", { 2, false, true } }, { "int16", { 2, false, true } },
    { "ushort", { 2, false, false } }, { "uint16", { 2, false, false } },
    { "int", { 4, false, true } }, { "int32", { 4, false, true } }, { "uint", { 4, false, false } },
    { "uint32", { 4, false, false } }, { "float", { 4, true, true } },
    { "float32", { 4, true, true } }, { "double", { 8, true, true } },
    { "float64", { 8, true, true } } };
  for (const auto& known : types)
  {
    if (name == known.Name)
    {
      return known.Value;
    }
  }
  Malformed("unknown type '" + name.substr(0, 40) + "'");
}

Property ParseProperty(std::istringstream& words)
{
  Property property;
  std::string type;
  words >> type;
  if (type == "list")
  {
    std::string length;
    words >> length >> type;
    property.List = true;
    property.Length = ParseType(length);
    if (property.Length.Float)
    {
      Malformed("a list's length cannot be of type " + length);
    }
  }
  property.Item = ParseType(type);
  if (!(words >> property.Name))
  {
    Malformed("a property has no name");
  }
  return property;
}

Format ParseFormat(const std::string& name)
{
  if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
  {
    Malformed("unknown format '" + name.substr(0, 40) + "'");
  }
  return name == "ascii"             ? Format::Ascii
    : name == "binary_little_endian" ? Format::LittleEndian
                                     : Format::BigEndian;
}

/** The next line, without its end; longer ones than VTK's buffer are an error. */
std::string ReadLine(std::istream& file, const char* where)
{
  constexpr std::size_t limit = 4000;
  std::string line;
  if (!std::getline(file, line))
  {
    Malformed(std::string("it ends in its ") + where);
  }
  if (line.size() > limit)
  {
    Malformed("a line is too long");
  }
  if (!line.empty() && line.back() == '\r')
  {
    line.pop_back();
  }
  return line;
}

Header ParseHeader(std::istream& file)
{
  char magic[3] = {};
  file.read(magic, 3);
  if (std::string(magic, 3) != "ply" || !ReadLine(file, "header").empty())
  {
    Malformed("it does not start with 'ply'");
  }
  Header header;
  bool hasFormat = false;
  for (;;)
  {
    std::istringstream words(ReadLine(file, "header"));
    std::string keyword;
    std::string name;
    words >> keyword;
    if (keyword == "end_header")
    {
      break;
    }
    if (keyword == "format")
    {
      words >> name;
      header.BodyFormat = ParseFormat(name);
      hasFormat = true;
    }
    else if (keyword == "element")
    {
      Element element;
      if (!(words >> element.Name >> element.Count) || element.Count < 0 ||
        element.Count > std::numeric_limits<int>::max())
      {
        Malformed("an element has no valid count");
      }
      header.Elements.push_back(element);
    }
    else if (keyword == "property")
    {
      if (header.Elements.empty())
      {
        Malformed("a property comes before any element");
      }
      header.Elements.back().Properties.push_back(ParseProperty(words));
    }
    else if (keyword != "comment" && keyword != "obj_info")
    {
      Malformed("unknown word in the header: '" + keyword.substr(0, 40) + "'");
    }
  }
  if (!hasFormat)
  {
    Malformed("the header names no format");
  }
  return header;
}

bool IsCorners(const Property& property)
{
  return property.List && (property.Name == "vertex_indices" || property.Name == "vertex_index");
}

void CheckVertexElement(const Element& element)
{
  int found = 0;
  for (const Property& property : element.Properties)
  {
    found += property.Name == "x" || property.Name == "y" || property.Name == "z" ? 1 : 0;
    if (property.List)
    {
      Malformed("a vertex has a list");
    }
  }
  if (found != 3)
  {
    Malformed("a vertex needs x, y and z");
  }
}

void CheckFaceElement(const Element& element)
{
  int found = 0;
  for (const Property& property : element.Properties)
  {
    found += IsCorners(property) && !property.Item.Float ? 1 : 0;
  }
  if (found != 1)
  {
    Malformed("a face needs one list 'vertex_indices' of integers");
  }
}

/** Vertices, then perhaps faces, each with what VTK reads of them; others are skipped. */
void CheckElements(const Header& header)
{
  int vertices = 0;
  int faces = 0;
  for (const Element& element : header.Elements)
  {
    if (element.Name == "vertex")
    {
      CheckVertexElement(element);
      ++vertices;
    }
    if (element.Name == "face")
    {
      CheckFaceElement(element);
      ++faces;
      if (vertices == 0)
      {
        Malformed("the faces come before the vertices");
      }
    }
  }
  if (vertices != 1 || faces > 1)
  {
    Malformed("it needs one element 'vertex' and at most one 'face'");
  }
}

/** The numbers of the body, one after the other; throws where they end too early. */
class Body
{
public:
  Body(std::istream& file, Format format)
    : File(file)
    , BodyFormat(format)
  {
  }

  /** To be called before each row of an element. */
  void BeginRow()
  {
    if (this->BodyFormat == Format::Ascii)
    {
      this->Line = ReadLine(this->File, "body");
      this->Rest = this->Line.c_str();
    }
  }

  double ReadNumber(const Type& type)
  {
    return this->BodyFormat == Format::Ascii ? this->ReadText() : this->ReadBinary(type);
  }

private:
  double ReadText()
  {
    char* end = nullptr;
    const double value = std::strtod(this->Rest, &end);
    if (end == this->Rest)
    {
      Malformed("a line of its body has too few numbers");
    }
    this->Rest = end;
    return value;
  }

  /** Integers as they are; of floating point numbers nothing but the size is of interest. */
  double ReadBinary(const Type& type)
  {
    unsigned char bytes[8] = {};
    if (!this->File.read(reinterpret_cast<char*>(bytes), type.Size))
    {
      Malformed("it ends in its body");
    }
    std::int64_t value = 0;
    for (int i = 0; i < type.Size && !type.Float; ++i)
    {
      const int source = this->BodyFormat == Format::BigEndian ? type.Size - 1 - i : i;
      value |= static_cast<std::int64_t>(bytes[source]) << (8 * i);
    }
    if (type.Signed && !type.Float)
    {
      const std::int64_t half = std::int64_t{ 1 } << (8 * type.Size - 1);
      value -= value >= half ? 2 * half : 0;
    }
    return static_cast<double>(value);
  }

  std::istream& File;
  Format BodyFormat;
  std::string Line;
  const char* Rest = nullptr;
};

void CheckCorner(double id, double vertexCount, std::int64_t face)
{
  if (!(id >= 0 && id < vertexCount) || id != std::floor(id))
  {
    std::ostringstream what;
    what.precision(17);
    what << "face " << face << " refers to point " << id << ", but there are " << vertexCount;
    Malformed(what.str());
  }
}

/** Reads a row; VTK holds the number of a face's corners in one byte. */
void CheckRow(Body& body, const Element& element, std::int64_t row, double vertexCount)
{
  constexpr double maximumCorners = 255;
  const bool face = element.Name == "face";
  double corners = -1;
  body.BeginRow();
  for (const Property& property : element.Properties)
  {
    const double length = property.List ? body.ReadNumber(property.Length) : 1;
    const bool isCorners = face && IsCorners(property);
    corners = isCorners ? length : corners;
    if (length < 0 || length != std::floor(length) || (isCorners && length > maximumCorners))
    {
      Malformed("a list is too long or too short");
    }
    if (face && property.List && property.Name == "texcoord" && length != 2 * corners)
    {
      Malformed("the texture coordinates do not fit the corners");
    }
    for (double i = 0; i < length; ++i)
    {
      const double number = body.ReadNumber(property.Item);
      if (isCorners)
      {
        CheckCorner(number, vertexCount, row);
      }
    }
  }
}
} // namespace

void CheckPly(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const Header header = ParseHeader(file);
  CheckElements(header);
  Body body(file, header.BodyFormat);
  double vertexCount = 0;
  for (const Element& element : header.Elements)
  {
    for (std::int64_t row = 0; row < element.Count; ++row)
    {
      CheckRow(body, element, row, vertexCount);
    }
    vertexCount = element.Name == "vertex" ? static_cast<double>(element.Count) : vertexCount;
  }
}
