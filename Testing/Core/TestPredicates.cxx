// Voronoi/Predicates against exact integers with the symbolic perturbation written out.

#include "Support/Random.h"
#include "TestChecks.h"
#include "Voronoi/Predicates.h"

#include <algorithm>
#include <vector>

using namespace remesh;

namespace
{
__extension__ typedef __int128 Integer;

/**
 * A polynomial in the perturbations of four sites, up to the third power of each. Coefficient
 * 64 e0 + 16 e1 + 4 e2 + e3 belongs to the powers e_r of the perturbation of the r-th lowest id:
 * with eps_0 << eps_1 << ... the terms then stand by decreasing size, however large they are.
 */
struct Polynomial
{
  Integer terms[256] = {};

  int sign() const
  {
    for (const Integer term : this->terms)
    {
      if (term != 0)
      {
        return term > 0 ? 1 : -1;
      }
    }
    return 0;
  }
};

/** The difference of two perturbed values: an integer, one perturbation up, one down. */
struct Difference
{
  Integer value[3];
  int code[3];
};

/** Sites with integer H values, by rank of their ids. */
struct Case
{
  std::vector<FacetSite> sites; // q, i, j and m

  /** H_ak - H_bk, perturbed. */
  Difference difference(int a, int b, int k) const
  {
    const auto value =
      static_cast<Integer>(this->sites[a].h[k]) - static_cast<Integer>(this->sites[b].h[k]);
    return { { value, 1, -1 }, { 0, this->code(a), this->code(b) } };
  }

  int code(int site) const
  {
    const auto rank = std::count_if(this->sites.begin(), this->sites.end(),
      [&](const FacetSite& other) { return other.id < this->sites[site].id; });
    return 64 >> (2 * rank);
  }
};

/** Adds sign * a * b, sign * a * b * c. */
void addProduct(Polynomial& sum, int sign, const Difference& a, const Difference& b)
{
  for (int s = 0; s < 3; ++s)
  {
    for (int t = 0; t < 3; ++t)
    {
      sum.terms[a.code[s] + b.code[t]] += sign * a.value[s] * b.value[t];
    }
  }
}

void addProduct(
  Polynomial& sum, int sign, const Difference& a, const Difference& b, const Difference& c)
{
  for (int s = 0; s < 3; ++s)
  {
    for (int t = 0; t < 3; ++t)
    {
      for (int r = 0; r < 3; ++r)
      {
        sum.terms[a.code[s] + b.code[t] + c.code[r]] += sign * a.value[s] * b.value[t] * c.value[r];
      }
    }
  }
}

constexpr int q = 0, i = 1, j = 2, m = 3;

/** Sign of H_ak - H_bk, perturbed. */
int compareAtCorner(const Case& sites, int a, int b, int k)
{
  Polynomial value;
  const Difference difference = sites.difference(a, b, k);
  for (int s = 0; s < 3; ++s)
  {
    value.terms[difference.code[s]] += difference.value[s];
  }
  return value.sign();
}

/** Sign of H_q - H_i where H_i = H_j on the edge from k to l; u, w: differences to H_i. */
int compareOnEdge(const Case& sites, int k, int l)
{
  Polynomial determinant;
  addProduct(determinant, 1, sites.difference(j, i, k), sites.difference(q, i, l));
  addProduct(determinant, -1, sites.difference(j, i, l), sites.difference(q, i, k));
  // The crossing is where i and j change places: u_k and u_l have different signs.
  return determinant.sign() * compareAtCorner(sites, j, i, k);
}

/** Sign of (1,1,1) . (u x v), u = H_j - H_i and v = H_m - H_i. */
int orientation(const Case& sites)
{
  Polynomial sum;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3;
    addProduct(sum, 1, sites.difference(j, i, k), sites.difference(m, i, l));
    addProduct(sum, -1, sites.difference(j, i, l), sites.difference(m, i, k));
  }
  return sum.sign();
}

/** Sign of det(u, v, w). */
int determinantSign(const Case& sites)
{
  Polynomial sum;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3;
    const int n = (k + 2) % 3;
    const Difference w = sites.difference(q, i, n);
    addProduct(sum, 1, sites.difference(j, i, k), sites.difference(m, i, l), w);
    addProduct(sum, -1, sites.difference(j, i, l), sites.difference(m, i, k), w);
  }
  return sum.sign();
}

struct Count
{
  int wrong = 0;
  int checked = 0;

  void expect(bool right)
  {
    this->wrong += !right;
    ++this->checked;
  }
};

void checkCorners(const Case& sites, Count& count)
{
  for (int k = 0; k < 3; ++k)
  {
    const bool beats = beatsAtCorner(sites.sites[q], sites.sites[i], k);
    count.expect(beats == (compareAtCorner(sites, q, i, k) < 0));
    count.expect(beats != beatsAtCorner(sites.sites[i], sites.sites[q], k));
  }
}

/** On the edges that i and j share; q beats both or none of them. */
void checkEdges(const Case& sites, Count& count)
{
  const std::vector<FacetSite>& s = sites.sites;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3;
    const int atK = compareAtCorner(sites, j, i, k);
    if (atK == compareAtCorner(sites, j, i, l))
    {
      continue;
    }
    const bool beats = beatsOnEdge(s[q], s[i], s[j], k, atK > 0);
    const int expected = compareOnEdge(sites, k, l);
    count.expect(expected != 0 && beats == (expected < 0));
    count.expect(beats == beatsOnEdge(s[q], s[j], s[i], k, atK < 0));
  }
}

/** Where i, j and m meet; q beats all or none of them. */
void checkInside(const Case& sites, Count& count)
{
  std::vector<FacetSite> s = sites.sites;
  const int sense = orientation(sites);
  if (sense == 0)
  {
    return; // they meet nowhere
  }
  if (sense < 0)
  {
    std::swap(s[j], s[m]);
  }
  const bool beats = beatsInside(s[q], s[i], s[j], s[m]);
  const int expected = determinantSign(sites) * sense;
  count.expect(expected != 0 && beats == (expected < 0));
  count.expect(beats == beatsInside(s[q], s[j], s[m], s[i]));
  count.expect(beats == beatsInside(s[q], s[m], s[i], s[j]));
}

/** Reproducible random integers. */
struct Dice
{
  std::uint64_t seed;
  std::uint64_t next = 0;

  double below(double bound) { return std::floor(uniform01(this->seed, this->next++, 0) * bound); }
};

Case randomCase(Dice& dice, double largest)
{
  Case sites;
  std::vector<Index> ids = { 0, 1, 2, 3 };
  for (int k = 3; k > 0; --k)
  {
    std::swap(ids[k], ids[static_cast<int>(dice.below(k + 1))]);
  }
  for (const Index id : ids)
  {
    FacetSite site;
    site.id = 7 * id + 3;
    for (double& h : site.h)
    {
      h = dice.below(largest);
    }
    sites.sites.push_back(site);
  }
  return sites;
}

/** Moves q next to the plane of the others, so that determinants are small against their terms. */
void flatten(Case& sites, Dice& dice)
{
  std::vector<FacetSite>& s = sites.sites;
  const double a = dice.below(3) - 1;
  const double b = dice.below(3) - 1;
  for (int k = 0; k < 3; ++k)
  {
    const double offset = dice.below(3) - 1;
    s[q].h[k] = s[i].h[k] + a * (s[j].h[k] - s[i].h[k]) + b * (s[m].h[k] - s[i].h[k]) + offset;
  }
}

using Checks = void (*)(const Case&, Count&);

void run(int cases, std::uint64_t seed, double largest, bool flat, Checks checks, Count& count)
{
  Dice dice{ seed };
  for (int c = 0; c < cases; ++c)
  {
    Case sites = randomCase(dice, largest);
    if (flat)
    {
      flatten(sites, dice);
    }
    checks(sites, count);
  }
}

/** Small grids: ties of all kinds, coincident sites among them. */
void testTies()
{
  Count count;
  for (const double largest : { 1.0, 2.0, 3.0, 4.0, 7.0 })
  {
    run(40000, 1, largest, false, checkCorners, count);
    run(40000, 2, largest, false, checkEdges, count);
    run(40000, 3, largest, false, checkInside, count);
  }
  CHECK_EQUAL(count.wrong, 0);
  CHECK(count.checked > 1500000);
}

/** Large values: random, and next to ties, where doubles alone do not decide. */
void testLarge()
{
  for (const bool flat : { false, true })
  {
    Count count;
    run(100000, 4, 0x1p50, flat, checkCorners, count);
    run(100000, 5, 0x1p50, flat, checkEdges, count);
    run(100000, 6, 0x1p38, flat, checkInside, count);
    run(50000, 7, 0x1p20, flat, checkInside, count);
    CHECK_EQUAL(count.wrong, 0);
    CHECK(count.checked > 500000);
  }
}

/** A common scale and a common shift of all H values change nothing. */
void testInvariance()
{
  Dice dice{ 8 };
  Count count;
  for (int c = 0; c < 20000; ++c)
  {
    Case sites = randomCase(dice, 5.0);
    const int sense = orientation(sites);
    if (sense < 0)
    {
      std::swap(sites.sites[j], sites.sites[m]);
    }
    Case other = sites;
    for (FacetSite& site : other.sites)
    {
      for (double& h : site.h)
      {
        h = (h + 1000.0) * 0x1p-70;
      }
    }
    const std::vector<FacetSite>& s = sites.sites;
    const std::vector<FacetSite>& t = other.sites;
    if (sense != 0)
    {
      count.expect(beatsInside(s[q], s[i], s[j], s[m]) == beatsInside(t[q], t[i], t[j], t[m]));
    }
    const int atCorner = compareAtCorner(sites, j, i, 1);
    if (atCorner != compareAtCorner(sites, j, i, 2))
    {
      count.expect(beatsOnEdge(s[q], s[i], s[j], 1, atCorner > 0) ==
        beatsOnEdge(t[q], t[i], t[j], 1, atCorner > 0));
    }
  }
  CHECK_EQUAL(count.wrong, 0);
  CHECK(count.checked > 10000);
}

/** At each crossing of an edge exactly one of many sites wins against all others. */
void testOneWinner()
{
  Dice dice{ 9 };
  Count count;
  for (int c = 0; c < 2000; ++c)
  {
    std::vector<FacetSite> sites(8);
    for (std::size_t s = 0; s < sites.size(); ++s)
    {
      sites[s] = { static_cast<Index>(s), { dice.below(4), dice.below(4), dice.below(4) } };
    }
    // From corner to corner along edge 0: always one next cell, and the last one wins the end.
    const auto winsCorner = [&](const FacetSite& a, int k)
    {
      return std::all_of(sites.begin(), sites.end(),
        [&](const FacetSite& b) { return b.id == a.id || beatsAtCorner(a, b, k); });
    };
    const auto start = std::find_if(
      sites.begin(), sites.end(), [&](const FacetSite& a) { return winsCorner(a, 0); });
    count.expect(start != sites.end());
    const FacetSite* now = &*start;
    for (int steps = 0; steps < 8 && !winsCorner(*now, 1); ++steps)
    {
      const FacetSite* next = nullptr;
      int winners = 0;
      for (const FacetSite& a : sites)
      {
        const bool crosses =
          a.id != now->id && beatsAtCorner(a, *now, 1) && beatsAtCorner(*now, a, 0);
        const bool first = crosses &&
          std::none_of(sites.begin(), sites.end(),
            [&](const FacetSite& b)
            { return b.id != a.id && b.id != now->id && beatsOnEdge(b, *now, a, 0, true); });
        winners += first;
        next = first ? &a : next;
      }
      count.expect(winners == 1);
      now = next ? next : now;
    }
    count.expect(winsCorner(*now, 1));
  }
  CHECK_EQUAL(count.wrong, 0);
}

/** The filter alone agrees where it is sure, and knows nothing of ties: what the benchmark leaves.
 */
void testFilterAlone()
{
  const FacetSite i{ 2, { 0, 4, 4 } };
  const FacetSite j{ 3, { 4, 0, 4 } };
  const FacetSite m{ 4, { 4, 4, 0 } };
  const auto decide = [&](Index id, double h, Decisions decisions)
  {
    const FacetSite q{ id, { h, h, h } };
    return std::make_pair(
      beatsOnEdge(q, i, j, 0, true, decisions), beatsInside(q, i, j, m, decisions));
  };
  for (const double h : { 1.0, 3.0 }) // they cross at 2, and meet at 8 / 3
  {
    CHECK(decide(1, h, Decisions::FilterAlone) == decide(1, h, Decisions::Exact));
  }
  const FacetSite first{ 1, { 2, 2, 2 } };
  const FacetSite last{ 5, { 2, 2, 2 } };
  CHECK(beatsOnEdge(first, i, j, 0, true) && !beatsOnEdge(last, i, j, 0, true));
  CHECK_EQUAL(beatsOnEdge(first, i, j, 0, true, Decisions::FilterAlone),
    beatsOnEdge(last, i, j, 0, true, Decisions::FilterAlone));
}
}

int TestPredicates(int, char*[])
{
  testFilterAlone();
  testTies();
  testLarge();
  testInvariance();
  testOneWinner();
  return test::result();
}
