#include "Mesh/PointPacket.h"

#include "Support/CompiledInLanes.h"

#include <Eigen/Geometry>

#include <limits>

namespace remesh
{
namespace
{
/** Of the angle at the corner; digits are lost with its square. */
constexpr double minSineOfPacket = 1e-2;

/** Twice what is above 0, and 0 for the rest: without a comparison. */
template <int W>
[[gnu::always_inline]] inline void doublePositive(Lanes<W>& values)
{
  for (int k = 0; k < values.parts; ++k)
  {
    typename LaneBits<W>::Vector bits;
    typename Lanes<W>::Vector absolute;
    std::memcpy(&bits, &values.part[k], sizeof bits);
    bits &= ~0ULL >> 1;
    std::memcpy(&absolute, &bits, sizeof bits);
    values.part[k] += absolute;
  }
}

template <class L>
[[gnu::always_inline]] inline void multiply(const Point3& a, const L (&b)[3], L& product)
{
  product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class L>
[[gnu::always_inline]] inline void loadPoints(const PointPacket& packet, L (&points)[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    load(packet.point[axis], points[axis]);
  }
}

struct BoxEvaluation
{
  template <class L>
  [[gnu::always_inline]] static inline double run(const PacketBox& task)
  {
    L sum{};
    for (int axis = 0; axis < 3; ++axis)
    {
      L x;
      load(task.packet.point[axis], x);
      L below = task.boxes.lower[axis][task.box] - x;
      L above = x - task.boxes.upper[axis][task.box];
      doublePositive(below);
      doublePositive(above);
      sum += below * below + above * above; // one of them is 0
    }
    sum *= 0.25;
    L known;
    load(task.packet.squared, known);
    typename L::Bits nearer;
    findNegative(sum - known, nearer);
    keepChosen(nearer, std::numeric_limits<double>::infinity(), sum);
    double squared[lanes];
    store(sum, squared);
    return minOfLanes(squared);
  }
};

struct GroupEvaluation
{
  template <class L>
  [[gnu::always_inline]] static inline void run(const PacketGroup& task)
  {
    L sum{};
    for (int axis = 0; axis < 3; ++axis)
    {
      L below;
      L above;
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
  template <class L>
  [[gnu::always_inline]] static inline void measureEdge(
    const Point3& edge, double inverse, const L (&way)[3], L& squared)
  {
    L share;
    multiply(edge, way, share);
    share *= inverse;
    keepPositive(share);
    share = 1.0 - share;
    keepPositive(share);
    share = 1.0 - share;
    squared = L{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const L rest = way[axis] - share * edge[axis];
      squared += rest * rest;
    }
  }

  template <class L>
  [[gnu::always_inline]] static inline void takeLess(const L& by, L& values)
  {
    typename L::Bits less;
    findNegative(by - values, less);
    replaceChosen(by, less, values);
  }

  /** Where points are in a triangle's plane. */
  template <class L>
  struct Feet
  {
    L squared;                ///< distances from the plane
    L side{};                 ///< at least: those of the feet from the triangle, squared
    typename L::Bits outside; ///< of the triangle
  };

  /** Adds what a weight tells: if it is negative, how far the foot is from the edge. */
  template <class L>
  [[gnu::always_inline]] static inline void addSide(const L& weight, double height2, Feet<L>& feet)
  {
    typename L::Bits outside;
    typename L::Bits farther;
    findNegative(weight, outside);
    addNegative(weight, feet.outside);
    const L side = weight * weight * height2;
    findNegative(feet.side - side, farther);
    replaceChosen(side, outside & farther, feet.side);
  }

  template <class L>
  [[gnu::always_inline]] static inline void findFeet(
    const PacketTriangle& triangle, const L (&way)[3], Feet<L>& feet)
  {
    L u;
    L v;
    multiply(triangle.first, way, u);
    multiply(triangle.second, way, v);
    feet.outside = {};
    addSide(u, triangle.heights[0], feet);
    addSide(v, triangle.heights[1], feet);
    addSide(1.0 - u - v, triangle.heights[2], feet);
    feet.squared = L{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const L rest = way[axis] - u * triangle.edges[0][axis] - v * triangle.edges[1][axis];
      feet.squared += rest * rest;
    }
  }

  template <class L>
  [[gnu::always_inline]] static inline void measureEdges(
    const PacketTriangle& triangle, const L (&way)[3], const typename L::Bits& wanted, L& squared)
  {
    L least;
    L other;
    measureEdge(triangle.edges[0], triangle.inverse[0], way, least);
    measureEdge(triangle.edges[1], triangle.inverse[1], way, other);
    takeLess(other, least);
    L second[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      second[axis] = way[axis] - triangle.edges[0][axis];
    }
    measureEdge(triangle.edges[2], triangle.inverse[2], second, other);
    takeLess(other, least);
    replaceChosen(least, wanted, squared);
  }

  template <class L>
  [[gnu::always_inline]] static inline unsigned run(const PacketPlaces& task)
  {
    L way[3];
    loadPoints(task.packet, way);
    for (int axis = 0; axis < 3; ++axis)
    {
      way[axis] -= task.triangle.corner[axis];
    }
    Feet<L> feet;
    findFeet(task.triangle, way, feet);
    L known;
    load(task.packet.squared, known);
    typename L::Bits nearer;
    findNegative(feet.squared + feet.side - known, nearer);
    if (bitsOf(nearer) == 0)
    {
      return 0;
    }
    L squared = feet.squared;
    if (bitsOf(nearer & feet.outside) != 0)
    {
      measureEdges(task.triangle, way, feet.outside, squared);
    }
    typename L::Bits less; // the others have not been measured
    findNegative(squared - known, less);
    nearer = nearer & less;
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
  if (!(determinant > minSineOfPacket * minSineOfPacket * uu * vv && ww > 0.0))
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
  return CompiledInLanes<BoxEvaluation, const PacketBox&>::select(set);
}

PacketGroupEvaluation packetGroupEvaluation(InstructionSet set)
{
  return CompiledInLanes<GroupEvaluation, const PacketGroup&>::select(set);
}

PacketPlaceEvaluation packetPlaceEvaluation(InstructionSet set)
{
  return CompiledInLanes<PlaceEvaluation, const PacketPlaces&>::select(set);
}
}
