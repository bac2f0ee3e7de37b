#include "OffReader.h"

#include "Corners.h"
#include "Failure.h"
#include "TextLines.h"

#include <vtkPolyData.h>

#include <cmath>
#include <string_view>

namespace
{
[[noreturn]] void MalformedOff(const TextLines& lines, const std::string& what)
{
  throw Failure("malformed OFF file, " + lines.Where() + " " + what);
}

/** The first word of the next line that has one. */
std::string_view NextLine(TextLines& lines)
{
  while (lines.Next())
  {
    const std::string_view word = lines.Word();
    if (!word.empty())
    {
      return word;
    }
  }
  throw Failure("malformed OFF file, it ends too early");
}

long long Integer(const TextLines& lines, std::string_view word, long long most, const char* what)
{
  long long number = 0;
  if (!ParseInteger(word, number) || number < 0 || number > most)
  {
    MalformedOff(lines, "has '" + std::string(word.substr(0, 40)) + "' for " + what);
  }
  return number;
}
void ReadPoints(TextLines& lines, long long count, CornerMesh& mesh)
{
  for (long long i = 0; i < count; ++i)
  {
    std::string_view word = NextLine(lines);
    for (int c = 0; c < 3; ++c, word = lines.Word())
    {
      double x = 0.0;
      if (!ParseNumber(word, x) || !std::isfinite(x))
      {
        MalformedOff(lines, "has no three finite coordinates");
      }
      mesh.Points.push_back(x);
    }
  }
}

void ReadFaces(TextLines& lines, long long count, long long pointCount, CornerMesh& mesh)
{
  for (long long i = 0; i < count; ++i)
  {
    const long long size = Integer(lines, NextLine(lines), 1 << 20, "the number of corners");
    for (long long c = 0; c < size; ++c)
    {
      Corner corner;
      corner.Point = Integer(lines, lines.Word(), pointCount - 1, "a corner");
      mesh.Corners.push_back(corner);
    }
    if (size < 3)
    {
      MalformedOff(lines, "has a face with fewer than three corners");
    }
    mesh.Offsets.push_back(static_cast<vtkIdType>(mesh.Corners.size()));
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadOff(const std::string& text)
{
  TextLines lines(text, TextLines::COMMENTS);
  std::string_view word = NextLine(lines);
  const std::size_t end = word.size() < 3 ? 0 : word.size() - 3;
  if (word.substr(end) != "OFF" ||
    word.substr(0, end).find_first_not_of("CNST") != std::string_view::npos)
  {
    MalformedOff(lines, "does not start with 'OFF' (other dimensions cannot be read)");
  }
  word = lines.Word(); // the numbers may follow on the same line
  word = word.empty() ? NextLine(lines) : word;
  const auto most = static_cast<long long>(text.size());
  const long long pointCount = Integer(lines, word, most, "the number of points");
  const long long faceCount = Integer(lines, lines.Word(), most, "the number of faces");
  CornerMesh mesh;
  ReadPoints(lines, pointCount, mesh);
  ReadFaces(lines, faceCount, pointCount, mesh);
  return MakeSurface(mesh);
}
