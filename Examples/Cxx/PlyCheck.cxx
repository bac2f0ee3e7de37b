#include "PlyCheck.h"

#include "Failure.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace
{
struct Property
{
  std::string Name;
  int CountSize = 0; // bytes of a list's length, 0: no list
  int Size = 0;      // bytes of an item
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;

  bool HasLists() const
  {
    bool lists = false;
    for (const Property& property : this->Properties)
    {
      lists = lists || property.CountSize > 0;
    }
    return lists;
  }
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

int TypeSize(const std::string& type)
{
  const struct
  {
    const char* Name;
    int Size;
  } types[] = { { "char", 1 }, { "int8", 1 }, { "uchar", 1 }, { "uint8", 1 }, { "short", 2 },
    { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 }, { "int", 4 }, { "int32", 4 }, { "uint", 4 },
    { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  for (const auto& known : types)
  {
    if (type == known.Name)
    {
      return known.Size;
    }
  }
  Malformed("unknown type '" + type.substr(0, 40) + "'");
}

Property ParseProperty(std::istringstream& words)
{
  Property property;
  std::string type;
  words >> type;
  if (type == "list")
  {
    std::string countType;
    words >> countType >> type;
    if (countType.find("float") != std::string::npos || countType == "double")
    {
      Malformed("a list's length cannot be of type " + countType);
    }
    property.CountSize = TypeSize(countType);
  }
  property.Size = TypeSize(type);
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

void CheckVertices(const Header& header)
{
  for (const Element& element : header.Elements)
  {
    int found = 0;
    for (const Property& property : element.Properties)
    {
      const bool coordinate = property.Name == "x" || property.Name == "y" || property.Name == "z";
      found += coordinate && property.CountSize == 0 ? 1 : 0;
    }
    if (element.Name == "vertex" && found == 3)
    {
      return;
    }
  }
  Malformed("there are no vertices with x, y and z");
}

std::int64_t ReadLength(std::istream& file, int size, bool bigEndian)
{
  unsigned char bytes[4] = {};
  file.read(reinterpret_cast<char*>(bytes), size);
  std::uint32_t length = 0;
  for (int i = 0; i < size; ++i)
  {
    length |= static_cast<std::uint32_t>(bytes[bigEndian ? size - 1 - i : i]) << (8 * i);
  }
  return length;
}

void CheckBinaryBody(std::istream& file, const Header& header)
{
  const std::streamoff start = file.tellg();
  file.seekg(0, std::ios::end);
  std::int64_t left = file.tellg() - start;
  file.seekg(start);
  const auto take = [&](std::int64_t bytes, const Element& element)
  {
    left -= bytes;
    if (left < 0)
    {
      Malformed("it ends before its " + std::to_string(element.Count) + " elements '" +
        element.Name.substr(0, 40) + "' are complete");
    }
  };
  for (const Element& element : header.Elements)
  {
    if (!element.HasLists())
    {
      std::int64_t rowSize = 0;
      for (const Property& property : element.Properties)
      {
        rowSize += property.Size;
      }
      take(element.Count * rowSize, element);
      file.seekg(element.Count * rowSize, std::ios::cur);
      continue;
    }
    for (std::int64_t row = 0; row < element.Count; ++row)
    {
      for (const Property& property : element.Properties)
      {
        std::int64_t items = 1;
        if (property.CountSize > 0)
        {
          take(property.CountSize, element);
          items = ReadLength(file, property.CountSize, header.BodyFormat == Format::BigEndian);
        }
        take(items * property.Size, element);
        file.ignore(items * property.Size);
      }
    }
  }
}

void CheckAsciiBody(std::istream& file, const Header& header)
{
  for (const Element& element : header.Elements)
  {
    for (std::int64_t row = 0; row < element.Count; ++row)
    {
      const std::string line = ReadLine(file, "body");
      const char* rest = line.c_str();
      const auto number = [&]()
      {
        char* end = nullptr;
        const double value = std::strtod(rest, &end);
        if (end == rest)
        {
          Malformed("number " + std::to_string(row) + " of its elements '" +
            element.Name.substr(0, 40) + "' is incomplete");
        }
        rest = end;
        return value;
      };
      for (const Property& property : element.Properties)
      {
        const double items = property.CountSize > 0 ? number() : 1.0;
        for (double item = 0; item < items; ++item)
        {
          number();
        }
      }
    }
  }
}
} // namespace

void CheckPly(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const Header header = ParseHeader(file);
  CheckVertices(header);
  if (header.BodyFormat == Format::Ascii)
  {
    CheckAsciiBody(file, header);
  }
  else
  {
    CheckBinaryBody(file, header);
  }
}
