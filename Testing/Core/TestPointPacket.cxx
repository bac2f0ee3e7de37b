// Eight points at once, against boxes and triangles: the same bits for all sets of instructions,
// and what one point after the other gives.

#include "Mesh/ClosestPoint.h"
#include "Mesh/PointPacket.h"
#include "TestLanes.h"
#include "TestSupport.h"

#include <algorithm>
#include <cmath>

using namespace remesh;
using test::infinity;
using test::randomPoint;

namespace
{
/** Random points; of some it is known that they are near. */
PointPacket randomPacket(std::uint64_t seed)
{
  PointPacket packet;
  for (int lane = 0; lane < lanes; ++lane)
  {
    const Point3 point = 2.0 * randomPoint(seed, 50 + lane);
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.point[axis][lane] = point[axis];
    }
    packet.squared[lane] = lane % 3 == 0 ? infinity : uniform01(seed, lane, 7);
  }
  return packet;
}

/** One box in each lane, the last without a point. */
BoxGroup randomBoxes(std::uint64_t seed)
{
  BoxGroup boxes;
  for (int box = 0; box < lanes; ++box)
  {
    const Point3 a = randomPoint(seed, 2 * box);
    const Point3 b = randomPoint(seed, 2 * box + 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      boxes.lower[axis][box] = box + 1 < lanes ? std::min(a[axis], b[axis]) : infinity;
      boxes.upper[axis][box] = box + 1 < lanes ? std::max(a[axis], b[axis]) : -infinity;
    }
  }
  return boxes;
}

Point3 lowerOf(const BoxGroup& boxes, int box)
{
  return { boxes.lower[0][box], boxes.lower[1][box], boxes.lower[2][box] };
}

Point3 upperOf(const BoxGroup& boxes, int box)
{
  return { boxes.upper[0][box], boxes.upper[1][box], boxes.upper[2][box] };
}

void testBoxes()
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const PointPacket packet = randomPacket(seed);
    const BoxGroup boxes = randomBoxes(seed);
    for (int box = 0; box + 1 < lanes; ++box)
    {
      double expected = infinity;
      for (int lane = 0; lane < lanes; ++lane)
      {
        const Point3 point = packet.at(lane);
        const double squared = (lowerOf(boxes, box) - point)
                                 .cwiseMax(point - upperOf(boxes, box))
                                 .cwiseMax(0.0)
                                 .squaredNorm();
        expected = squared < packet.squared[lane] ? std::min(expected, squared) : expected;
      }
      const double found = packetBoxEvaluation(InstructionSet::Baseline)({ packet, boxes, box });
      CHECK(found == expected || std::abs(found - expected) < 1e-15);
      for (const InstructionSet set : test::availableSets())
      {
        CHECK(packetBoxEvaluation(set)({ packet, boxes, box }) == found);
      }
    }
    CHECK_EQUAL(
      packetBoxEvaluation(widestInstructionSet())({ packet, boxes, lanes - 1 }), infinity);
  }
}

void testGroups()
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    const BoxGroup boxes = randomBoxes(seed);
    const Point3 center = 3.0 * randomPoint(seed, 99);
    const Point3 half = Point3::Constant(0.2);
    const Point3 lower = center - half;
    const Point3 upper = center + half;
    for (const InstructionSet set : test::availableSets())
    {
      double squared[lanes];
      packetGroupEvaluation(set)({ boxes, lower, upper, squared });
      for (int box = 0; box + 1 < lanes; ++box)
      {
        CHECK_NEAR(squared[box],
          (lowerOf(boxes, box) - upper)
            .cwiseMax(lower - upperOf(boxes, box))
            .cwiseMax(0.0)
            .squaredNorm(),
          1e-14);
      }
      CHECK_EQUAL(squared[lanes - 1], infinity);
    }
  }
}

/** Triangles of all shapes, `width` times as wide as they are long. */
void testTriangles(double width)
{
  int tested = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed)
  {
    const Point3 a = randomPoint(seed, 0);
    const Point3 b = randomPoint(seed, 1);
    const Point3 c = a + uniform01(seed, 2, 0) * (b - a) + width * randomPoint(seed, 3);
    PacketTriangle triangle;
    if (!triangle.set(a, b, c))
    {
      continue; // told
    }
    ++tested;
    const PointPacket before = randomPacket(seed);
    PointPacket baseline = before;
    const unsigned bits = packetPlaceEvaluation(InstructionSet::Baseline)({ triangle, baseline });
    for (int lane = 0; lane < lanes; ++lane)
    {
      const double squared = closestOnTriangle(before.at(lane), a, b, c).squared;
      CHECK_NEAR(baseline.squared[lane], std::min(squared, before.squared[lane]), 1e-13);
      CHECK_EQUAL((bits >> lane & 1) != 0, baseline.squared[lane] < before.squared[lane]);
    }
    for (const InstructionSet set : test::availableSets())
    {
      PointPacket packet = before;
      const unsigned found = packetPlaceEvaluation(set)({ triangle, packet });
      CHECK_EQUAL(found, bits);
      CHECK(std::equal(packet.squared, packet.squared + lanes, baseline.squared));
    }
  }
  CHECK(width < 1e-3 ? tested == 0 : tested > 250);
}
}

int TestPointPacket(int, char*[])
{
  testBoxes();
  testGroups();
  testTriangles(1.0);
  testTriangles(0.05);
  testTriangles(1e-5); // digits are lost
  return test::result();
}
