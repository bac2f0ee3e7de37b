/**
 * @file TestChecks.h
 * @brief Checks that print what failed and go on.
 *
 * A test is a function `int TestName(int, char*[])` that ends with `return test::result();`.
 */
#ifndef remesh_TestChecks_h
#define remesh_TestChecks_h

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

namespace remesh::test
{
inline int& failures()
{
  static int count = 0;
  return count;
}

inline void check(bool passed, const char* file, int line, const std::string& what)
{
  if (!passed)
  {
    ++failures();
    std::cerr << file << ":" << line << ": " << what << "\n";
  }
}

template <class A, class B>
std::string described(const char* left, const char* right, const A& a, const B& b)
{
  std::ostringstream text;
  text.precision(17);
  text << left << " is " << a << ", expected " << right << " = " << b;
  return text.str();
}

/** What a test function returns. */
inline int result()
{
  return failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

#define CHECK(condition)                                                                           \
  ::remesh::test::check(static_cast<bool>(condition), __FILE__, __LINE__, #condition)

/** Both sides are printable and comparable. */
#define CHECK_EQUAL(value, expected)                                                               \
  ::remesh::test::check((value) == (expected), __FILE__, __LINE__,                                 \
    ::remesh::test::described(#value, #expected, (value), (expected)))

/** |value - expected| <= tolerance, an absolute one. */
#define CHECK_NEAR(value, expected, tolerance)                                                     \
  ::remesh::test::check(std::abs((value) - (expected)) <= (tolerance), __FILE__, __LINE__,         \
    ::remesh::test::described(#value, #expected, (value), (expected)))

#endif
