#include "MeshSections.h"

#include "Failure.h"
#include "TextLines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace
{
constexpr std::pair<const char*, int> sectionCodes[] = { { "Dimension", 3 }, { "Vertices", 4 },
  { "Triangles", 6 }, { "Quadrilaterals", 7 }, { "End", 54 }, { "SolAtVertices", 62 } };

/** Words and numbers, whatever the lines. */
class TextSections : public MeshSections
{
public:
  TextSections(const std::string& text, const std::string& extension)
    : Lines(text, TextLines::COMMENTS)
    , Extension(extension)
    , Bytes(static_cast<long long>(text.size()))
  {
    if (extension == ".mesh")
    {
      const std::string_view word = this->Word();
      if (word != "MeshVersionFormatted")
      {
        this->Malformed(word, "its first word, which is 'MeshVersionFormatted' in text files");
      }
    }
  }

  std::string Next() override
  {
    double number = 0.0;
    std::string_view word = this->Word();
    while (!word.empty() && ParseNumber(word, number))
    {
      word = this->Word();
    }
    return word == "End" ? "" : std::string(word);
  }

  double Number(const char* what) override
  {
    double number = 0.0;
    const std::string_view word = this->Word();
    if (!ParseNumber(word, number) || !std::isfinite(number))
    {
      this->Malformed(word, what);
    }
    return number;
  }

  long long Integer(long long least, long long most, const char* what) override
  {
    long long number = 0;
    const std::string_view word = this->Word();
    if (!ParseInteger(word, number) || number < least || number > most)
    {
      this->Malformed(word, what);
    }
    return number;
  }

  long long ShortInteger(long long least, long long most, const char* what) override
  {
    return this->Integer(least, most, what);
  }

  long long Size() const override { return this->Bytes; }

private:
  /** Empty at the end of the file. */
  std::string_view Word()
  {
    for (;;)
    {
      const std::string_view word = this->Lines.Word();
      if (!word.empty() || !this->Lines.Next())
      {
        return word;
      }
    }
  }

  [[noreturn]] void Malformed(std::string_view word, const std::string& what) const
  {
    const std::string file = "malformed " + this->Extension + " file, ";
    throw Failure(word.empty() ? file + "it ends too early"
                               : file + this->Lines.Where() + " has '" +
          std::string(word.substr(0, 40)) + "' for " + what);
  }

  TextLines Lines;
  std::string Extension;
  long long Bytes;
};

/** The number 1 that a binary file begins with, in the order of this machine or the other one. */
constexpr std::uint32_t ownOrder = 1U;
constexpr std::uint32_t otherOrder = 0x01000000U;

std::uint32_t FirstNumber(const std::string& bytes)
{
  std::uint32_t first = 0;
  std::memcpy(&first, bytes.data(), std::min(bytes.size(), sizeof(first)));
  return first;
}

class BinarySections : public MeshSections
{
public:
  BinarySections(const std::string& bytes, const std::string& extension)
    : Bytes(bytes)
    , Extension(extension)
    , Swapped(FirstNumber(bytes) == otherOrder)
    , End(bytes.size())
  {
    if (!IsBinaryMesh(bytes))
    {
      this->Malformed("its first four bytes are not the number 1, as in binary files");
    }
    this->Position = sizeof(std::uint32_t);
    this->Version = static_cast<int>(this->ShortInteger(1, 4, "the version, 1 to 4"));
    this->Following = this->Position;
  }

  std::string Next() override
  {
    if (this->Following == 0) // what comes after the last one
    {
      return "";
    }
    this->Position = this->Following;
    this->End = this->Bytes.size();
    const auto code = this->Read<std::int32_t>();
    const std::size_t where = this->Position;
    const long long next =
      this->Version < 3 ? this->Read<std::int32_t>() : this->Read<std::int64_t>();
    const auto* found = std::find_if(std::begin(sectionCodes), std::end(sectionCodes),
      [=](const auto& section) { return section.second == code; });
    const std::string name = found == std::end(sectionCodes) ? "another" : found->first;
    if (name == "End")
    {
      return "";
    }
    // Forward alone: else a file could lead in a circle.
    if (next > this->Size())
    {
      this->Malformed("it ends too early");
    }
    if (next != 0 && next < static_cast<long long>(this->Position))
    {
      this->Malformed(where, next, "where the next section is");
    }
    this->Following = static_cast<std::size_t>(next);
    this->End = next == 0 ? this->Bytes.size() : this->Following;
    return name;
  }

  double Number(const char* what) override
  {
    const std::size_t where = this->Position;
    const double number = this->Version == 1 ? this->Read<float>() : this->Read<double>();
    if (!std::isfinite(number))
    {
      this->Malformed(where, number, what);
    }
    return number;
  }

  long long Integer(long long least, long long most, const char* what) override
  {
    return this->Version < 4 ? this->ShortInteger(least, most, what)
                             : this->Checked<std::int64_t>(least, most, what);
  }

  long long ShortInteger(long long least, long long most, const char* what) override
  {
    return this->Checked<std::int32_t>(least, most, what);
  }

  long long Size() const override { return static_cast<long long>(this->Bytes.size()); }

private:
  template <typename Value>
  Value Read()
  {
    if (this->Position > this->End || this->End - this->Position < sizeof(Value))
    {
      this->Malformed(this->End == this->Bytes.size()
          ? "it ends too early"
          : "a section has more than fits before byte " + std::to_string(this->End));
    }
    char bytes[sizeof(Value)];
    std::memcpy(bytes, this->Bytes.data() + this->Position, sizeof(Value));
    this->Position += sizeof(Value);
    if (this->Swapped)
    {
      std::reverse(bytes, bytes + sizeof(Value));
    }
    Value value;
    std::memcpy(&value, bytes, sizeof(Value));
    return value;
  }

  template <typename Whole>
  long long Checked(long long least, long long most, const char* what)
  {
    const std::size_t where = this->Position;
    const long long number = this->Read<Whole>();
    if (number < least || number > most)
    {
      this->Malformed(where, number, what);
    }
    return number;
  }

  [[noreturn]] void Malformed(const std::string& sentence) const
  {
    throw Failure("malformed " + this->Extension + " file, " + sentence);
  }

  template <typename Value>
  [[noreturn]] void Malformed(std::size_t where, Value value, const char* what) const
  {
    this->Malformed(
      "byte " + std::to_string(where) + " has " + std::to_string(value) + " for " + what);
  }

  const std::string& Bytes;
  std::string Extension;
  bool Swapped;
  int Version = 2;
  std::size_t Position = 0;
  std::size_t End;           // of the section, or of all
  std::size_t Following = 0; // where the next section is; 0: there is none
};
} // namespace

bool IsBinaryMesh(const std::string& bytes)
{
  const std::uint32_t first = FirstNumber(bytes);
  return bytes.size() >= sizeof(first) && (first == ownOrder || first == otherOrder);
}

int SectionCode(const std::string& name)
{
  for (const auto& [section, code] : sectionCodes)
  {
    if (name == section)
    {
      return code;
    }
  }
  return 0;
}

std::unique_ptr<MeshSections> OpenMeshSections(
  const std::string& bytes, const std::string& extension)
{
  if (extension == ".meshb" || extension == ".solb")
  {
    return std::make_unique<BinarySections>(bytes, extension);
  }
  return std::make_unique<TextSections>(bytes, extension);
}
