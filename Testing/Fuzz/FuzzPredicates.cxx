// The decisions on any H values agree with rational arithmetic, and with each other.

#include "FuzzSupport.h"
#include "TestFacetSites.h"

namespace
{
using namespace remesh;

/** How the pairs of four sites are ordered at a corner: no circles. */
void checkOrder(const std::vector<FacetSite>& sites)
{
  for (int k = 0; k < 3; ++k)
  {
    int won[4] = {};
    for (int a = 0; a < 4; ++a)
    {
      int wins = 0;
      for (int b = 0; b < 4; ++b)
      {
        wins += a != b && beatsAtCorner(sites[a], sites[b], k);
      }
      ++won[wins];
    }
    FUZZ_CHECK(won[0] == 1 && won[1] == 1 && won[2] == 1 && won[3] == 1);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  fuzz::Numbers numbers(bytes);
  while (!bytes.empty())
  {
    std::vector<FacetSite> sites = test::anyFacetSites(numbers, 4);
    test::disturb(sites, numbers);
    test::shuffleIds(sites, numbers);
    test::DecisionCount count;
    test::checkDecisions(sites, count);
    FUZZ_CHECK(count.wrong == 0);
    checkOrder(sites);
    ++fuzz::cases();
  }
  return 0;
}
