/**
 * @file SharedArray.h
 * @brief An array that does not change, held once however often it is copied.
 */
#ifndef remesh_SharedArray_h
#define remesh_SharedArray_h

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace remesh
{
/** Reads like a `const std::vector`, and is one where a function asks for it. */
template <class T>
class SharedArray
{
public:
  SharedArray() = default;
  SharedArray(const SharedArray&) = default; // a move is a copy: what is left is an array, too
  SharedArray& operator=(const SharedArray&) = default;
  SharedArray(std::vector<T> values) // NOLINT: as a vector is assigned to a vector
    : m_values(std::make_shared<const std::vector<T>>(std::move(values)))
    , m_begin(m_values->data())
    , m_size(m_values->size())
  {
  }

  operator const std::vector<T>&() const // NOLINT
  {
    static const std::vector<T> none;
    return m_values ? *m_values : none;
  }

  const T& operator[](std::size_t k) const { return m_begin[k]; }
  const T* begin() const { return m_begin; }
  const T* end() const { return m_begin + m_size; }
  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }

  friend bool operator==(const SharedArray& a, const SharedArray& b)
  {
    const std::vector<T>& other = b;
    return a.m_begin == b.m_begin || static_cast<const std::vector<T>&>(a) == other;
  }

private:
  std::shared_ptr<const std::vector<T>> m_values;
  const T* m_begin = nullptr; ///< of the values: one step less on the way to them
  std::size_t m_size = 0;
};
}

#endif
