/**
 * @file ParameterCheck.h
 * @brief Whether a filter's parameters are within what is allowed.
 *
 * Setters keep what they are given: a value out of range is an error when the filter runs, never
 * another value.
 */
#ifndef remesh_ParameterCheck_h
#define remesh_ParameterCheck_h

#include "Support/Status.h"

#include <limits>
#include <sstream>
#include <type_traits>

namespace remesh
{
/** Tells the first parameter that is out of its range; NaN is out of each. */
class ParameterCheck
{
  template <class Value>
  using Same = std::common_type_t<Value>; // lets the value alone decide on the type

public:
  /** From `lowest` to `highest`; a type's largest value, or VTK_DOUBLE_MAX, is no limit. */
  template <class Value>
  ParameterCheck& within(const char* name, Value value, Same<Value> lowest, Same<Value> highest)
  {
    if (m_status.ok() && !(value >= lowest && value <= highest))
    {
      std::ostringstream text;
      text << name << " must be " << (isLimit(highest) ? "from " : "at least ") << lowest;
      if (isLimit(highest))
      {
        text << " to " << highest;
      }
      text << ", but is " << value << ".";
      m_status = Status::invalid(text.str());
    }
    return *this;
  }

  const Status& status() const { return m_status; }

private:
  template <class Value>
  static bool isLimit(Value highest)
  {
    constexpr double largest = 1e299; // VTK_DOUBLE_MAX
    return highest < std::numeric_limits<Value>::max() && static_cast<double>(highest) < largest;
  }

  Status m_status;
};
}

#endif
