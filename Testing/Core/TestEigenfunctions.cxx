// Spectrum/: eigenvalues of spheres, tori and squares against known ones, eigenfunctions by their
// equation, equal parts, many functions, kernels, borders, errors, the same bytes on any threads.

#include "Spectrum/SpectralEmbedding.h"
#include "TestCancels.h"
#include "TestSupport.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr double pi2 = 9.8696044010893586;

SpectralEmbedding embed(
  const SurfaceMesh& mesh, const SpectralOptions& options, const RunControl& control = RunControl())
{
  SpectralEmbedding embedding;
  const Status status = embedSpectrally(mesh, options, control, embedding);
  check(status.ok(), __FILE__, __LINE__, status.message);
  CHECK_EQUAL(embedding.eigenvalues.size(), static_cast<std::size_t>(options.dimension));
  CHECK(std::is_sorted(embedding.eigenvalues.begin(), embedding.eigenvalues.end()));
  return embedding;
}

SpectralOptions optionsOf(Index dimension, MassMatrix mass = MassMatrix::Lumped,
  BorderCondition border = BorderCondition::Natural)
{
  SpectralOptions options;
  options.dimension = dimension;
  options.scaling = SpectralScaling::None;
  options.mass = mass;
  options.border = border;
  return options;
}

void checkValues(
  const std::vector<double>& found, std::vector<double> known, double within, int line)
{
  std::sort(known.begin(), known.end());
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    check(std::abs(found[k] / known[k] - 1.0) < within, __FILE__, line,
      std::to_string(k) + ": " + std::to_string(found[k]) + " for " + std::to_string(known[k]));
  }
}

/** l (l + 1), 2 l + 1 times. */
void testSphere()
{
  const SurfaceMesh mesh = meshOf(icosphere(5)); // 10242 points
  std::vector<double> known;
  for (int l = 1; l <= 7; ++l)
  {
    known.insert(known.end(), static_cast<std::size_t>(2 * l + 1), l * (l + 1.0));
  }
  for (const MassMatrix mass : { MassMatrix::Lumped, MassMatrix::Consistent })
  {
    checkValues(embed(mesh, optionsOf(63, mass)).eigenvalues, known, 0.01, __LINE__);
  }
}

void testSquare()
{
  const SurfaceMesh mesh = meshOf(gridPatch(80, 80));
  std::vector<double> natural;
  std::vector<double> fixed;
  for (int i = 0; i < 12; ++i)
  {
    for (int j = 0; j < 12; ++j)
    {
      natural.push_back(pi2 * (i * i + j * j));
      fixed.push_back(pi2 * ((i + 1) * (i + 1) + (j + 1) * (j + 1)));
    }
  }
  std::sort(natural.begin(), natural.end());
  natural.erase(natural.begin()); // the constant
  for (const MassMatrix mass : { MassMatrix::Lumped, MassMatrix::Consistent })
  {
    checkValues(embed(mesh, optionsOf(15, mass)).eigenvalues, natural, 0.01, __LINE__);
    const SpectralEmbedding held = embed(mesh, optionsOf(15, mass, BorderCondition::Fixed));
    checkValues(held.eigenvalues, fixed, 0.01, __LINE__);
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const Point3& at = mesh.points[p];
      const bool isBorder = std::min({ at[0], at[1], 1.0 - at[0], 1.0 - at[1] }) == 0.0;
      CHECK((held.unknowns[p] == noIndex) == isBorder);
    }
  }
}

/** A thin torus is nearly flat: (i / R)^2 + (j / r)^2, but for r / R. */
void testTorus()
{
  const SurfaceMesh mesh = meshOf(torus(60.0, 1.0, 600, 24));
  std::vector<double> known;
  for (int i = -40; i <= 40; ++i)
  {
    known.push_back(i * i / 3600.0);
  }
  known.erase(std::find(known.begin(), known.end(), 0.0));
  checkValues(embed(mesh, optionsOf(50)).eigenvalues, known, 0.01, __LINE__);
}

/** K f = lambda M f, and the functions are orthonormal: for several bands. */
void testEquation()
{
  const SurfaceMesh mesh = meshOf(torus(3.0, 1.0, 60, 26));
  SurfaceLaplacian laplacian;
  CHECK(
    buildLaplacian(mesh, MassMatrix::Consistent, BorderCondition::Natural, RunControl(), laplacian)
      .ok());
  Eigenpairs pairs;
  CHECK(findEigenfunctions(laplacian, 300, RunControl(), pairs).ok());
  const Eigen::MatrixXd weighted = laplacian.mass * pairs.functions;
  const Eigen::Map<const Eigen::VectorXd> values(pairs.values.data(), 300);
  const Eigen::MatrixXd rest =
    laplacian.stiffness * pairs.functions - weighted * values.asDiagonal();
  for (int k = 0; k < 300; ++k)
  {
    CHECK(rest.col(k).norm() < 1e-6 * values[k] * weighted.col(k).norm());
  }
  const Eigen::MatrixXd gram = pairs.functions.transpose() * weighted;
  CHECK_NEAR((gram - Eigen::MatrixXd::Identity(300, 300)).cwiseAbs().maxCoeff(), 0.0, 1e-6);
  // All of them: the same as by a dense matrix.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> dense(
    Eigen::MatrixXd(laplacian.stiffness), Eigen::MatrixXd(laplacian.mass), Eigen::EigenvaluesOnly);
  CHECK_NEAR(
    (dense.eigenvalues().segment(1, 300) - values).cwiseAbs().maxCoeff() / values[299], 0.0, 1e-9);
}

/** Twelve equal spheres: eigenvalues that are equal 36 times, and constants on each. */
void testParts()
{
  TriangleSoup soup;
  for (int k = 0; k < 12; ++k)
  {
    append(soup, icosphere(2), Point3(3.0 * k, 0.0, 0.0)); // 162 points
  }
  const std::vector<double> one = embed(meshOf(icosphere(2)), optionsOf(8)).eigenvalues;
  const std::vector<double> all = embed(meshOf(soup), optionsOf(96)).eigenvalues;
  for (std::size_t k = 0; k < all.size(); ++k)
  {
    CHECK_NEAR(all[k] / one[k / 12], 1.0, 1e-6);
  }
}

void testScalings()
{
  const SurfaceMesh mesh = meshOf(torus(3.0, 1.0, 60, 24));
  const SpectralEmbedding plain = embed(mesh, optionsOf(10));
  SpectralOptions options = optionsOf(10);
  options.time = 0.7;
  const auto factor = [&](SpectralScaling scaling, std::size_t k)
  {
    options.scaling = scaling;
    const SpectralEmbedding other = embed(mesh, options);
    return other.functions(5, static_cast<Eigen::Index>(k)) /
      plain.functions(5, static_cast<Eigen::Index>(k));
  };
  for (const std::size_t k : { 0, 4, 9 })
  {
    const double value = plain.eigenvalues[k];
    CHECK_NEAR(factor(SpectralScaling::CommuteTime, k), 1.0 / std::sqrt(value), 1e-12);
    CHECK_NEAR(factor(SpectralScaling::Biharmonic, k), 1.0 / value, 1e-12);
    CHECK_NEAR(factor(SpectralScaling::Diffusion, k), std::exp(-0.7 * value), 1e-12);
  }
}

/** All functions of a small surface, and one too many. */
void testErrors()
{
  SpectralEmbedding embedding;
  const SurfaceMesh small = meshOf(icosphere(1)); // 42 points
  CHECK_EQUAL(embed(small, optionsOf(41)).functions.cols(), 41);
  Status status = embedSpectrally(small, optionsOf(42), RunControl(), embedding);
  CHECK_EQUAL(
    status.message, "The surface has 41 eigenfunctions beside constants, but 42 are asked for.");
  const SurfaceMesh strip = meshOf(gridPatch(9, 1));
  status = embedSpectrally(
    strip, optionsOf(1, MassMatrix::Lumped, BorderCondition::Fixed), RunControl(), embedding);
  CHECK(status.message.find("All points are on borders") == 0);
}

void testCancelled()
{
  const SurfaceMesh mesh = meshOf(gridPatch(40, 30));
  for (const MassMatrix mass : { MassMatrix::Lumped, MassMatrix::Consistent })
  {
    for (const BorderCondition border : { BorderCondition::Natural, BorderCondition::Fixed })
    {
      checkCancels(
        "eigenfunctions",
        [&](const RunControl& control)
        {
          SpectralEmbedding embedding;
          return embedSpectrally(mesh, optionsOf(60, mass, border), control, embedding);
        },
        24);
    }
  }
}

void testThreads()
{
  const SurfaceMesh mesh = meshOf(icosphere(4));
  const SpectralEmbedding expected = embed(mesh, optionsOf(20));
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    const SpectralEmbedding embedding = embed(mesh, optionsOf(20), control);
    CHECK(embedding.eigenvalues == expected.eigenvalues);
    CHECK(embedding.functions == expected.functions);
  }
}
}

int TestEigenfunctions(int, char*[])
{
  testSphere();
  testSquare();
  testTorus();
  testEquation();
  testParts();
  testScalings();
  testErrors();
  testCancelled();
  testThreads();
  return result();
}
