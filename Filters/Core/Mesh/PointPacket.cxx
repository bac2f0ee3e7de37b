#include "Mesh/PointPacket.h"

#include <Eigen/Geometry>

namespace remesh
{
namespace
{
/** Of the angle at the corner; digits are lost with its square. */
constexpr double leastSine = 1e-2;

/** A vector of R^3 for each point. */
using LanePoint = Lanes[3];

[[gnu::always_inline]] inline void clampNegative(Lanes& values)
{
  LaneBits negative;
  findNegative(values, negative);
  replaceChosen(Lanes{}, negative, values);
}

/** Twice what is above 0, by the sign's bit: compilers take comparisons apart. */
[[gnu::always_inline]] inline void doublePositive(Lanes& values)
{
  LaneBits bits;
  std::memcpy(&bits, &values, sizeof values);
  bits &= ~0ULL >> 1;
  Lanes absolute;
  std::memcpy(&absolute, &bits, sizeof bits);
  values += absolute;
}

[[gnu::always_inline]] inline void multiply(const Point3& a, const LanePoint& b, Lanes& product)
{
  product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[gnu::always_inline]] inline void loadPoints(const PointPacket& packet, LanePoint& points)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    load(packet.point[axis], points[axis]);
  }
}

struct BoxEvaluation
{
  [[gnu::always_inline]] static inline double run(const PacketBox& task)
  {
    Lanes sum{};
    for (int axis = 0; axis < 3; ++axis)
    {
      Lanes x;
      load(task.packet.point[axis], x);
      Lanes below = task.boxes.lower[axis][task.box] - x;
      Lanes above = x - task.boxes.upper[axis][task.box];
      doublePositive(below);
      doublePositive(above);
      sum += below * below + above * above; // one of them is 0
    }
    sum *= 0.25;
    Lanes known;
    load(task.packet.squared, known);
    LaneBits nearer;
    findNegative(sum - known, nearer);
    double squared[lanes];
    storeChosen(sum, nearer, squared);
    return leastOfLanes(squared);
  }
};

struct GroupEvaluation
{
  [[gnu::always_inline]] static inline void run(const PacketGroup& task)
  {
    Lanes sum{};
    for (int axis = 0; axis < 3; ++axis)
    {
      Lanes below;
      Lanes above;
      load(task.boxes.lower[axis], below);
      load(task.boxes.upper[axis], above);
      below -= task.upper[axis];
      above = task.lower[axis] - above;
      doublePositive(below);
      doublePositive(above);
      sum += below * below + above * above;
    }
    sum *= 0.25;
    store(sum, task.squared);
  }
};

struct PlaceEvaluation
{
  /** Squared distances from an edge that begins where `way` does. */
  [[gnu::always_inline]] static inline void measureEdge(
    const Point3& edge, double inverse, const LanePoint& way, Lanes& squared)
  {
    Lanes share;
    multiply(edge, way, share);
    share *= inverse;
    clampNegative(share);
    share = 1.0 - share;
    clampNegative(share);
    share = 1.0 - share;
    squared = Lanes{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lanes rest = way[axis] - share * edge[axis];
      squared += rest * rest;
    }
  }

  [[gnu::always_inline]] static inline void takeLess(const Lanes& by, Lanes& values)
  {
    LaneBits less;
    findNegative(by - values, less);
    replaceChosen(by, less, values);
  }

  /** Where points are in a triangle's plane. */
  struct Feet
  {
    Lanes squared;    ///< distances from the plane
    Lanes side{};     ///< at least: those of the feet from the triangle, squared
    LaneBits outside; ///< of the triangle
  };

  /** Adds what a weight tells: if it is negative, how far the foot is from the edge. */
  [[gnu::always_inline]] static inline void addSide(const Lanes& weight, double height2, Feet& feet)
  {
    LaneBits outside;
    LaneBits farther;
    findNegative(weight, outside);
    feet.outside |= outside;
    const Lanes side = weight * weight * height2;
    findNegative(feet.side - side, farther);
    replaceChosen(side, outside & farther, feet.side);
  }

  [[gnu::always_inline]] static inline void findFeet(
    const PacketTriangle& triangle, const LanePoint& way, Feet& feet)
  {
    Lanes u;
    Lanes v;
    multiply(triangle.first, way, u);
    multiply(triangle.second, way, v);
    feet.outside = LaneBits{};
    addSide(u, triangle.heights[0], feet);
    addSide(v, triangle.heights[1], feet);
    addSide(1.0 - u - v, triangle.heights[2], feet);
    feet.squared = Lanes{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lanes rest = way[axis] - u * triangle.edges[0][axis] - v * triangle.edges[1][axis];
      feet.squared += rest * rest;
    }
  }

  [[gnu::always_inline]] static inline void measureEdges(
    const PacketTriangle& triangle, const LanePoint& way, const LaneBits& wanted, Lanes& squared)
  {
    Lanes least;
    Lanes other;
    measureEdge(triangle.edges[0], triangle.inverse[0], way, least);
    measureEdge(triangle.edges[1], triangle.inverse[1], way, other);
    takeLess(other, least);
    LanePoint second;
    for (int axis = 0; axis < 3; ++axis)
    {
      second[axis] = way[axis] - triangle.edges[0][axis];
    }
    measureEdge(triangle.edges[2], triangle.inverse[2], second, other);
    takeLess(other, least);
    replaceChosen(least, wanted, squared);
  }

  [[gnu::always_inline]] static inline unsigned run(const PacketPlaces& task)
  {
    LanePoint way;
    loadPoints(task.packet, way);
    for (int axis = 0; axis < 3; ++axis)
    {
      way[axis] -= task.triangle.corner[axis];
    }
    Feet feet;
    findFeet(task.triangle, way, feet);
    Lanes known;
    load(task.packet.squared, known);
    LaneBits nearer;
    findNegative(feet.squared + feet.side - known, nearer);
    if (bitsOf(nearer) == 0)
    {
      return 0;
    }
    Lanes squared = feet.squared;
    if (bitsOf(nearer & feet.outside) != 0)
    {
      measureEdges(task.triangle, way, feet.outside, squared);
    }
    LaneBits less; // the others have not been measured
    findNegative(squared - known, less);
    nearer &= less;
    replaceChosen(squared, nearer, known);
    store(known, task.packet.squared);
    return bitsOf(nearer);
  }
};
}

bool PacketTriangle::set(const Point3& a, const Point3& b, const Point3& c)
{
  this->corner = a;
  this->edges[0] = b - a;
  this->edges[1] = c - a;
  this->edges[2] = c - b;
  const double uu = this->edges[0].squaredNorm();
  const double vv = this->edges[1].squaredNorm();
  const double ww = this->edges[2].squaredNorm();
  const double uv = this->edges[0].dot(this->edges[1]);
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > leastSine * leastSine * uu * vv && ww > 0.0))
  {
    return false;
  }
  const double inverseOfAll = 1.0 / determinant;
  this->inverse[0] = 1.0 / uu;
  this->inverse[1] = 1.0 / vv;
  this->inverse[2] = 1.0 / ww;
  this->heights[0] = determinant * this->inverse[1];
  this->heights[1] = determinant * this->inverse[0];
  this->heights[2] = determinant * this->inverse[2];
  this->first = inverseOfAll * (vv * this->edges[0] - uv * this->edges[1]);
  this->second = inverseOfAll * (uu * this->edges[1] - uv * this->edges[0]);
  return true;
}

PacketBoxEvaluation packetBoxEvaluation(InstructionSet set)
{
  return CompiledFor<BoxEvaluation, const PacketBox&>::select(set);
}

PacketGroupEvaluation packetGroupEvaluation(InstructionSet set)
{
  return CompiledFor<GroupEvaluation, const PacketGroup&>::select(set);
}

PacketPlaceEvaluation packetPlaceEvaluation(InstructionSet set)
{
  return CompiledFor<PlaceEvaluation, const PacketPlaces&>::select(set);
}
}
