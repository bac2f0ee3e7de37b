// Repair/PlacedCandidate and PlacedMesh: what is wrong with a placed mesh, and what is kept.

#include "Repair/Improve.h"
#include "Repair/PlacedCandidate.h"
#include "TestPushedBand.h"

#include <algorithm>
#include <memory>

using namespace remesh;
using test::crossingsOf;
using test::PushedBand;

namespace
{
/** The row of the table: a run parts them with all else that it mends. */
void testRow()
{
  PushedBand band;
  CHECK(band.repair().ok());
  CHECK(crossingsOf(band.triangles, band.placed.positions).empty());
  CHECK_EQUAL(band.placed.crossings, 0);
  CHECK(band.placed.edits.movedVertices > 0);
  CHECK_EQUAL(band.placed.edits.inverted, static_cast<Offset>(band.inverted().size()));
  PushedBand held; // nothing can be parted where no vertex may move, but by flips
  held.fixed.assign(held.fixed.size(), 1);
  const std::vector<Point3> pushed = held.placed.positions;
  const Offset before = held.partable();
  CHECK(held.repair().ok());
  CHECK(held.placed.positions == pushed);
  CHECK(held.placed.crossings > 0);
  CHECK(held.placed.crossings <= before);
  CHECK_EQUAL(held.placed.crossings, held.partable());
}

/** Puts vertices back to where they were sound, all but one, which it moves by so much. */
class PullBack : public Proposal<PlacedCandidate>
{
public:
  PullBack(PushedBand& band, const Point3& shift)
    : m_band(band)
    , m_shift(shift)
  {
  }
  bool answers(const PlacedCandidate& candidate) const override
  {
    return candidate.verdict().crossings > 0;
  }
  Status edit(PlacedCandidate&, int, const RunControl&, bool& done) override
  {
    m_band.placed.positions = m_band.sound;
    m_band.placed.positions[5] += m_shift;
    done = true;
    return Status::success();
  }

private:
  PushedBand& m_band;
  Point3 m_shift;
};

/** What parts triangles is kept, unless it inverts any. */
void testJudgement()
{
  for (const double shift : { 0.0, 0.5 })
  {
    PushedBand band;
    const WholeSurface whole(band.mesh, RunControl());
    const RunControl control;
    const PlacedTask task{ band.problem, band.near, whole, band.sound, band.sound, control };
    PlacedCandidate candidate(task, band.triangles, band.placed);
    const Offset crossings = band.partable();
    CHECK(candidate.count(MeshFault::Inverted).ok());
    CHECK(candidate.count(MeshFault::Stray).ok());
    CHECK_EQUAL(candidate.verdict().crossings, 0); // not counted yet
    CHECK(candidate.count(MeshFault::Crossing).ok());
    CHECK_EQUAL(candidate.verdict().crossings, crossings);
    const Verdict before = candidate.verdict();
    const std::vector<Point3> pushed = band.placed.positions;
    Improvement<PlacedCandidate>::Table table;
    table.push_back(
      { "pull back", std::make_unique<PullBack>(band, Point3(0.0, 0.0, shift)), 1, 0 });
    CHECK(Improvement<PlacedCandidate>(table, candidate).run(control).ok());
    CHECK((candidate.verdict() == before) == (shift > 0.0));
    CHECK((band.placed.positions == pushed) == (shift > 0.0));
    CHECK(shift > 0.0 || candidate.verdict() == Verdict());
    CHECK(band.inverted().empty());
  }
}

/** A mesh that is known is not looked at again but where it has changed. */
void testKnownMesh()
{
  const PushedBand band;
  InvertedSearch search(band.near);
  const std::vector<Index> told{ 3, 40, 41 };
  search.know(band.triangles, band.sound, told);
  std::vector<Index> found;
  CHECK(search.find(band.triangles, band.sound, RunControl(), found).ok());
  CHECK(found == told);
  std::vector<Point3> moved = band.sound;
  moved[band.triangles[40][0]] *= 1.0 + 1e-9;
  CHECK(search.find(band.triangles, moved, RunControl(), found).ok());
  CHECK(std::find(found.begin(), found.end(), 3) != found.end());
  CHECK(std::find(found.begin(), found.end(), 40) == found.end());
}

}

int TestPlacedCandidate(int, char*[])
{
  testRow();
  testJudgement();
  testKnownMesh();
  return test::result();
}
