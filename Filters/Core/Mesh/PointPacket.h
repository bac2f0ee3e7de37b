/**
 * @file PointPacket.h
 * @brief Several points at once, how far they are from a box, and from a triangle.
 */
#ifndef remesh_PointPacket_h
#define remesh_PointPacket_h

#include "Mesh/BoxDistances.h"
#include "Support/Types.h"

namespace remesh
{
/** Points side by side, and the squared distances that they are known to be within. */
struct PointPacket
{
  double point[3][lanes];
  double squared[lanes];

  Point3 at(int lane) const
  {
    return { this->point[0][lane], this->point[1][lane], this->point[2][lane] };
  }
  double farthest() const { return *std::max_element(this->squared, this->squared + lanes); }
};

/** One of the boxes of a group against all points. */
struct PacketBox
{
  const PointPacket& packet;
  const BoxGroup& boxes;
  int box;
};

/** The least squared distance of the points that are nearer to it than known; infinity: of none. */
using PacketBoxEvaluation = double (*)(const PacketBox&);

/** The boxes of a group against the box around all points; `lanes` squared distances. */
struct PacketGroup
{
  const BoxGroup& boxes;
  const Point3& lower;
  const Point3& upper;
  double* squared;
};

using PacketGroupEvaluation = void (*)(const PacketGroup&);

/** A triangle, and what the points' places on it are found with. */
struct PacketTriangle
{
  Point3 corner;
  Point3 edges[3];   ///< from the corner to the second and the third one, and between these
  double inverse[3]; ///< of their squared lengths
  double heights[3]; ///< squared: of the second corner, the third, and the first one
  // Their products with a way from the corner are the weights of the other two corners.
  Point3 first;
  Point3 second;

  /** @return false for so narrow a triangle that the weights lose their digits. */
  bool set(const Point3& a, const Point3& b, const Point3& c);
};

/** Takes over the squared distances of the points that are nearer to the triangle than known. */
struct PacketPlaces
{
  const PacketTriangle& triangle;
  PointPacket& packet;
};

/** Returns a bit for each such point. */
using PacketPlaceEvaluation = unsigned (*)(const PacketPlaces&);

/** Compiled for a set of instructions; all give the same bits. */
PacketBoxEvaluation packetBoxEvaluation(InstructionSet set);
PacketGroupEvaluation packetGroupEvaluation(InstructionSet set);
PacketPlaceEvaluation packetPlaceEvaluation(InstructionSet set);
}

#endif
