#include "Comparison/SharedDistance.h"

#include <algorithm>

namespace remesh
{
namespace
{
void addPoint(const Point3& point, std::vector<double>& numbers)
{
  numbers.insert(numbers.end(), point.data(), point.data() + 3);
}

void addPoints(const std::vector<Point3>& points, Packet& packet)
{
  std::vector<double> numbers;
  numbers.reserve(3 * points.size());
  for (const Point3& point : points)
  {
    addPoint(point, numbers);
  }
  packet.add(numbers);
}

std::vector<Point3> takePoints(Packet& packet)
{
  std::vector<double> numbers;
  packet.take(numbers);
  std::vector<Point3> points;
  points.reserve(numbers.size() / 3);
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
  {
    points.emplace_back(numbers[k], numbers[k + 1], numbers[k + 2]);
  }
  return points;
}

/** The triangles [begin, end), each with points of its own. */
void addTriangles(const SampledTriangles& from, Offset begin, Offset end, Packet& packet)
{
  packet.add(begin);
  packet.add(from.area);
  packet.add(from.samplesPerArea);
  std::vector<double> corners;
  corners.reserve(static_cast<std::size_t>(9 * (end - begin)));
  for (Offset t = begin; t < end; ++t)
  {
    for (const Point3& corner : from.triangles.corners(t))
    {
      addPoint(corner, corners);
    }
  }
  packet.add(corners);
  packet.add(std::vector<char>(from.isFirst.begin() + 3 * begin, from.isFirst.begin() + 3 * end));
}
}

void tellToMeasure(OtherRanks& others, const SampledTriangles& from, const Triangles& to)
{
  Packet mesh;
  addPoints(to.points, mesh);
  mesh.add(to.triangles);
  const Blocks blocks = sampledBlocks(from.triangles.count());
  const Offset ranks = others.count() - 1; // the first is left out
  others.tell(RankOrder::MeasureDistance, mesh,
    [&](int rank)
    {
      const auto beginOf = [&](Offset before)
      { return std::min(blocks.size, blocks.begin(blocks.count() * before / ranks)); };
      Packet part;
      part.add(blocks.length);
      addTriangles(from, beginOf(rank - 1), beginOf(rank), part);
      return part;
    });
}

Status takeMeasured(OtherRanks& others, OneSidedDistance& distance)
{
  Status status;
  std::vector<DistanceSums> sums;
  while (others.moreAnswers())
  {
    Status next;
    Packet packet = others.takeAnswer(next);
    std::vector<DistanceSums> some;
    if (next.ok())
    {
      packet.take(some);
    }
    sums.insert(sums.end(), some.begin(), some.end());
    status = status.ok() ? next : status;
  }
  distance = distanceOf(sums);
  return status;
}

Status sumPartDistances(Packet& mesh, Packet& part, Packet& answer)
{
  const std::vector<Point3> points = takePoints(mesh);
  std::vector<Triple> triangles;
  mesh.take(triangles);
  mesh = Packet(); // makes room for the tree
  Blocks blocks;
  part.take(blocks.length);
  Offset first = 0;
  double area = 0.0;
  double samplesPerArea = 0.0;
  part.take(first);
  part.take(area);
  part.take(samplesPerArea);
  const std::vector<Point3> corners = takePoints(part);
  std::vector<char> isFirst;
  part.take(isFirst);
  std::vector<Triple> some(corners.size() / 3);
  for (std::size_t t = 0; t < some.size(); ++t)
  {
    const auto corner = static_cast<Index>(3 * t);
    some[t] = { corner, corner + 1, corner + 2 };
  }
  blocks.size = static_cast<Offset>(some.size());
  std::vector<DistanceSums> sums;
  Status status = sumDistances({ { corners, some }, isFirst, area, samplesPerArea, first },
    TriangleTree({ points, triangles }), blocks, RunControl(), sums);
  answer.add(sums);
  return status;
}
}
