/**
 * @file FuzzSupport.h
 * @brief What the fuzz drivers share: bytes as numbers, nasty surfaces, and failing loudly.
 *
 * A driver defines LLVMFuzzerTestOneInput. With clang and ANISOTROPIC_REMESHING_LIBFUZZER it runs
 * under libFuzzer; else FuzzMain.cxx gives it seeded random bytes, or the files it is called with.
 */
#ifndef FuzzSupport_h
#define FuzzSupport_h

#include "Support/Random.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#define FUZZ_CHECK(condition)                                                                      \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                         \
      std::abort();                                                                                \
    }                                                                                              \
  } while (false)

namespace fuzz
{
/** Takes small numbers from the front of the input; zeros when it is used up. */
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : m_next(data)
    , m_end(data + size)
  {
  }

  bool empty() const { return m_next == m_end; }
  unsigned byte() { return m_next == m_end ? 0u : *m_next++; }
  /** 0 <= result < bound <= 256. */
  int below(int bound) { return static_cast<int>(this->byte() % static_cast<unsigned>(bound)); }
  double fraction() { return (this->byte() * 256.0 + this->byte()) / 65536.0; }

private:
  const std::uint8_t* m_next;
  const std::uint8_t* m_end;
};

/** Choices straight from the input; numbers of 53 bits from it by way of a generator. */
class Numbers
{
public:
  explicit Numbers(Bytes& bytes)
    : m_bytes(bytes)
  {
  }

  /** 0 <= result < bound <= 256. */
  int below(int bound) { return m_bytes.below(bound); }
  double fraction()
  {
    m_state = remesh::mixBits(m_state ^ m_bytes.byte());
    return static_cast<double>(m_state >> 11) * 0x1p-53;
  }

private:
  Bytes& m_bytes;
  std::uint64_t m_state = 0;
};

/** Cases tried so far, by drivers that make several of one input. */
inline unsigned long& cases()
{
  static unsigned long count = 0;
  return count;
}

/** Coordinates that hit each other, and lie on lines and planes; `wild`: any double at all. */
inline double coordinate(Bytes& bytes, bool wild)
{
  const int kind = bytes.below(wild ? 24 : 8);
  switch (kind)
  {
    case 20:
      return std::numeric_limits<double>::quiet_NaN();
    case 21:
      return std::numeric_limits<double>::infinity();
    case 22:
      return 1e300;
    case 23:
      return std::numeric_limits<double>::denorm_min();
    case 6:
      return 1e-9 * bytes.fraction();
    case 7:
      return bytes.fraction();
    default:
      return bytes.below(4) - 1.0;
  }
}

/** Up to `maxPoints` points, and polygons and strips on them; `wild`: ids out of range, too. */
inline vtkSmartPointer<vtkPolyData> polyData(Bytes& bytes, int maxPoints, int maxCells, bool wild)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(bytes.below(4) == 0 ? VTK_FLOAT : VTK_DOUBLE);
  const bool flat = bytes.below(3) == 0;
  const int count = bytes.below(maxPoints + 1);
  for (int i = 0; i < count; ++i)
  {
    const double x = coordinate(bytes, wild);
    const double y = coordinate(bytes, wild);
    points->InsertNextPoint(x, y, flat ? 0.0 : coordinate(bytes, wild));
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  const int cells = count > 0 || wild ? bytes.below(maxCells + 1) : 0;
  for (int k = 0; k < cells; ++k)
  {
    const int kind = bytes.below(16);
    const int size = kind < 10 ? 3 : bytes.below(9);
    std::vector<vtkIdType> ids;
    for (int i = 0; i < size; ++i)
    {
      const bool outside = wild && bytes.below(64) == 0;
      ids.push_back(outside || count == 0 ? bytes.below(256) - 128 : bytes.below(count));
    }
    vtkCellArray* array = kind == 15 ? strips.Get() : polygons.Get();
    array->InsertNextCell(size, ids.data());
  }
  data->SetPolys(polygons);
  data->SetStrips(strips);
  return data;
}
}

#endif
