/**
 * @file Status.h
 * @brief How a stage of the core says that it cannot go on.
 *
 * The core never throws across its border and never prints: a stage that fails returns a code and
 * one sentence that says what is wrong and where.
 */
#ifndef remesh_Status_h
#define remesh_Status_h

#include <string>
#include <utility>

namespace remesh
{
enum class StatusCode
{
  Ok,
  EmptyInput,   ///< valid, but there is nothing to do
  InvalidInput, ///< the data or a parameter cannot be used
  Cancelled,    ///< the caller asked to stop
  OutOfMemory
};

struct [[nodiscard]] Status
{
  StatusCode code = StatusCode::Ok;
  std::string message; ///< one sentence, empty when ok

  bool ok() const { return this->code == StatusCode::Ok; }

  static Status success() { return {}; }
  static Status invalid(std::string why) { return { StatusCode::InvalidInput, std::move(why) }; }
  static Status empty(std::string why) { return { StatusCode::EmptyInput, std::move(why) }; }
  static Status cancelled() { return { StatusCode::Cancelled, "The run was cancelled." }; }
};
}

#endif
