#include "Comparison.h"

#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cstdio>

namespace
{
constexpr std::size_t labelWidth = 30;
constexpr std::size_t columnWidth = 16;

/** The column's number; "-" where the table has none. */
std::string Value(vtkTable* summary, const std::string& column, const char* format)
{
  if (summary->GetColumnByName(column.c_str()) == nullptr)
  {
    return "-";
  }
  char text[48];
  std::snprintf(text, sizeof(text), format, summary->GetValueByName(0, column.c_str()).ToDouble());
  return text;
}

std::string Line(std::string label, const std::string& first, const std::string& second)
{
  const auto padded = [](const std::string& text)
  { return std::string(columnWidth - std::min(columnWidth, text.size()), ' ') + text; };
  label.resize(std::max(label.size(), labelWidth), ' ');
  return label + padded(first) + "  " + padded(second) + '\n';
}

/** The end of a name that is too long for its column. */
std::string Shortened(const std::string& name)
{
  return name.size() <= columnWidth ? name : "..." + name.substr(name.size() - columnWidth + 3);
}

struct Row
{
  const char* Label;
  const char* Column; // of the first number
  const char* Format;
};
} // namespace

std::string ComparisonText(vtkTable* summary, const std::string& mesh, const std::string& reference)
{
  const Row shared[] = { { "points", "NumberOfPoints", "%.0f" },
    { "triangles", "NumberOfTriangles", "%.0f" }, { "area", "Area", "%.6g" },
    { "Euler characteristic", "EulerCharacteristic", "%.0f" },
    { "components", "NumberOfComponents", "%.0f" },
    { "boundary loops", "NumberOfBoundaryLoops", "%.0f" },
    { "non-manifold edges", "NumberOfNonManifoldEdges", "%.0f" },
    { "non-manifold points", "NumberOfNonManifoldPoints", "%.0f" },
    { "duplicate points", "NumberOfDuplicatePoints", "%.0f" },
    { "degenerate triangles", "NumberOfDegenerateTriangles", "%.0f" },
    { "consistently oriented (1: yes)", "IsConsistentlyOriented", "%.0f" } };
  const Row distances[] = { { "RMS distance", "RMSDistance", "%.4g" },
    { "largest distance", "MaximumDistance", "%.4g" },
    { "  mesh to surface", "MaximumDistanceToReference", "%.4g" },
    { "  surface to mesh", "MaximumDistanceFromReference", "%.4g" } };
  const Row shapes[] = { { "inverted triangles", "NumberOfFlippedTriangles", "%.0f" },
    { "mean turn of normals (degrees)", "MeanNormalDeviation", "%.3g" },
    { "mean least angle (degrees)", "MeanMinimumAngle", "%.3g" },
    { "least angle (degrees)", "LeastMinimumAngle", "%.3g" },
    { "mean quality (0 to 1)", "MeanQuality", "%.3g" },
    { "least quality", "MinimumQuality", "%.3g" },
    { "longest by shortest edge", "MaximumEdgeRatio", "%.4g" } };
  std::string text = Line("", Shortened(mesh), Shortened(reference));
  for (const Row& row : shared)
  {
    text += Line(row.Label, Value(summary, row.Column, row.Format),
      Value(summary, std::string("Reference") + row.Column, row.Format));
  }
  text += '\n' + Line("", "length", "of the diagonal");
  for (const Row& row : distances)
  {
    text += Line(row.Label, Value(summary, row.Column, row.Format),
      Value(summary, std::string("Relative") + row.Column, row.Format));
  }
  text += '\n';
  for (const Row& row : shapes)
  {
    std::string line = Line(row.Label, Value(summary, row.Column, row.Format), "");
    text += line.erase(line.find_last_not_of(" \n") + 1) + '\n';
  }
  return text;
}
