// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

namespace brinell
{

/// Owner of one object of a type that its header only declares, so that a class that has one as a member needs no destructor and
/// no moves of its own. It can be moved, not copied, and its object is as constant as itself.
template <typename T>
class Hidden
{
public:
  Hidden() = default; ///< empty
  /// Where T is complete.
  explicit Hidden(std::unique_ptr<T> object) : object_(object.release(), [](T* o) { delete o; }) {}

  [[nodiscard]] bool empty() const { return !object_; }
  T& operator*() { return *object_; }
  const T& operator*() const { return *object_; }
  T* operator->() { return object_.get(); }
  const T* operator->() const { return object_.get(); }

private:
  // With a function to delete it, the place that destroys the owner need not know T.
  std::unique_ptr<T, void (*)(T*)> object_{nullptr, [](T* /*none*/) {}};
};

/// A hidden object made of these arguments, where T is complete.
template <typename T, typename... Arguments>
[[nodiscard]] Hidden<T> make_hidden(Arguments&&... arguments)
{
  return Hidden<T>(std::unique_ptr<T>(new T{std::forward<Arguments>(arguments)...}));
}

} // namespace brinell
