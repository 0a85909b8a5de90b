// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "brinell/foundation/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace brinell
{

/// The numbers of a state by name, to be saved and restored. Each class lists its members in one function `exchange`, which
/// serves both directions, so that saving and restoring cannot disagree about the members.
class Archive
{
public:
  /// Fields by name. Large ones may be left where they are stored, to be read when they are asked for.
  struct Fields : std::map<std::string, std::vector<double>>
  {
    using map::map;
    std::map<std::string, std::size_t> left{}; ///< numbers of the fields that are not in the map
    /// Reads numbers of a field that has been left, from a first one on. @throws IoError
    std::function<void(const std::string& name, std::size_t first, std::span<double> values)> read{};
  };
  /// Receives the numbers of a field; the span is valid only during the call.
  using Take = std::function<void(const std::string& name, std::span<const double> values)>;
  /// Receives the numbers of a field of `size` in parts, one after the other, of which this one begins with number `first`.
  using TakePart =
      std::function<void(const std::string& name, std::size_t size, std::size_t first, std::span<const double> values)>;

  /// An empty archive: saves every number that is passed to it.
  Archive() = default;
  /// Saves by passing every field on to `take` at once, and stores none.
  /// @param take_part  for fields that are passed in parts; none: they are put together for `take`
  explicit Archive(Take take, TakePart take_part = {}) : take_(std::move(take)), take_part_(std::move(take_part)) {}
  /// A filled archive: restores the members that are passed to it from the stored numbers. An lvalue `stored` is not copied and
  /// must outlive the archive.
  explicit Archive(const Fields& stored) : lent_(&stored), gives_(true) {}
  explicit Archive(Fields&& stored) : fields_(std::move(stored)), gives_(true) {}

  /// @throws InputError if there is no field of this name, or its size differs from that of the member.
  void operator()(const std::string& name, std::vector<double>& values)
  {
    if (!gives())
      keep(name, values);
    else if (stored_size(name) == values.size() && is_left(name))
      stored().read(prefix_ + name, 0, values);
    else if (const std::vector<double>& field = at(name); field.size() == values.size())
      values = field;
    else
      throw InputError("the stored state has another size of " + prefix_ + name);
  }
  /// A field that is in memory in parts only: calls pass(first, values) for each part, from which `values` are saved, or to which they
  /// are restored.
  /// @param size  number of all values, a multiple of `part`
  /// @throws InputError if there is no field of this name and size
  void parts(const std::string& name, std::size_t size, std::size_t part,
             const std::function<void(std::size_t first, std::span<double> values)>& pass)
  {
    if (gives() && stored_size(name) != size)
      throw InputError("the stored state has another size of " + prefix_ + name);
    std::vector<double> values(part), all;
    for (std::size_t first = 0; first < size; first += part)
      if (gives())
      {
        read_part(name, first, values);
        pass(first, values);
      }
      else
      {
        pass(first, values);
        if (take_part_)
          take_part_(prefix_ + name, size, first, values);
        else
          all.insert(all.end(), values.begin(), values.end());
      }
    if (!all.empty())
      keep(name, all);
  }
  /// @throws InputError also if the type cannot represent the stored number
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const std::string& name, Number& value)
  {
    if constexpr (std::is_floating_point_v<Number>)
      exchange_number(name, value);
    else
      (*this)(name, value, std::numeric_limits<Number>::lowest(), std::numeric_limits<Number>::max());
  }
  /// A number that may serve as an index, a count or a number of repetitions, and so must be in bounds.
  /// @throws InputError also if the stored number is not in [least, most], or not an integer although the type is one
  template <typename Number>
  requires std::is_arithmetic_v<Number>
  void operator()(const std::string& name, Number& value, std::type_identity_t<Number> least,
                  std::type_identity_t<Number> most)
  {
    if (gives())
      require_between(name, at(name).front(), static_cast<double>(least), static_cast<double>(most),
                      !std::is_floating_point_v<Number>);
    exchange_number(name, value);
  }
  /// A member that lists its own members; their field names begin with its name.
  template <typename Part>
  requires requires(Part& part, Archive& archive) { part.exchange(archive); }
  void operator()(const std::string& name, Part& part)
  {
    const std::string outer = prefix_;
    prefix_ += name + ".";
    part.exchange(*this);
    prefix_ = outer;
  }

  /// A list of numbers whose length is part of the state.
  void list(const std::string& name, std::vector<double>& values)
  {
    std::size_t size = values.size();
    (*this)(name + ".size", size, 0, gives() ? stored_size(name) : size);
    values.resize(size);
    if (size > 0)
      (*this)(name, values);
  }
  /// A list of structs whose members are all numbers; its length is part of the state. One field is stored per member.
  template <typename Part>
  void list(const std::string& name, std::vector<Part>& parts)
  {
    const std::string first = prefix_ + name + member_of_list;
    std::size_t size = parts.size();
    (*this)(name + ".size", size, 0, gives() ? rows(first) : size);
    parts.resize(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      Archive one = gives() ? Archive(row(first, i)) : Archive();
      parts[i].exchange(one);
      if (!gives())
        for (const auto& [member, value] : one.fields_)
          fields_[first + member].push_back(value.front());
    }
    for (; take_ && !fields_.empty(); fields_.erase(fields_.begin()))
      take_(fields_.begin()->first, fields_.begin()->second);
  }

  /// Whether a field holds a member of the structs of a list; such fields must not be left.
  [[nodiscard]] static bool is_member_of_list(const std::string& name)
  {
    return name.find(member_of_list) != std::string::npos;
  }

  [[nodiscard]] bool gives() const { return gives_; }
  [[nodiscard]] const Fields& fields() const& { return fields_; }
  [[nodiscard]] Fields fields() && { return std::move(fields_); }

private:
  static constexpr const char* member_of_list = ".member.";

  void keep(const std::string& name, std::span<const double> values)
  {
    if (take_)
      take_(prefix_ + name, values);
    else
      fields_[prefix_ + name].assign(values.begin(), values.end());
  }
  template <typename Number>
  void exchange_number(const std::string& name, Number& value)
  {
    if (const auto number = static_cast<double>(value); !gives())
      keep(name, {&number, 1});
    else
      value = static_cast<Number>(at(name).front());
  }
  /// The largest numbers of 64-bit types are not representable as doubles: the nearest double is just above them and is rejected.
  void require_between(const std::string& name, double value, double least, double most, bool whole) const
  {
    constexpr double exact = 9007199254740992.0; // 2^53
    const bool inside = value >= least && (most > exact ? value < most : value <= most);
    if (!inside || (whole && value != std::trunc(value)))
      throw InputError("the stored state has a " + prefix_ + name + " of " + std::to_string(value) +
                       ", which is not possible");
  }
  [[nodiscard]] const Fields& stored() const { return lent_ ? *lent_ : fields_; }
  [[nodiscard]] bool is_left(const std::string& name) const { return stored().left.contains(prefix_ + name); }
  [[nodiscard]] std::size_t stored_size(const std::string& name) const
  {
    if (is_left(name))
      return stored().left.at(prefix_ + name);
    const auto found = stored().find(prefix_ + name);
    return found == stored().end() ? 0 : found->second.size();
  }
  void read_part(const std::string& name, std::size_t first, std::span<double> values) const
  {
    if (is_left(name))
      return stored().read(prefix_ + name, first, values);
    std::copy_n(at(name).begin() + static_cast<std::ptrdiff_t>(first), values.size(), values.begin());
  }
  /// Length of the longest field whose name begins with `first`.
  [[nodiscard]] std::size_t rows(const std::string& first) const
  {
    std::size_t longest = 0;
    for (auto field = stored().lower_bound(first); field != stored().end() && field->first.starts_with(first); ++field)
      longest = std::max(longest, field->second.size());
    return longest;
  }
  /// The i-th number of each field whose name begins with `first`.
  [[nodiscard]] Fields row(const std::string& first, std::size_t i) const
  {
    Fields result;
    for (auto field = stored().lower_bound(first); field != stored().end() && field->first.starts_with(first); ++field)
      if (i < field->second.size())
        result[field->first.substr(first.size())] = {field->second[i]};
    return result;
  }

  [[nodiscard]] const std::vector<double>& at(const std::string& name) const
  {
    const auto found = stored().find(prefix_ + name);
    if (found == stored().end() || found->second.empty())
      throw InputError("the stored state has no " + prefix_ + name);
    return found->second;
  }

  Take take_; ///< if set, receives the fields instead of `fields_`
  TakePart take_part_;
  Fields fields_;
  const Fields* lent_ = nullptr; ///< if set, fields of the caller that are used instead of `fields_`
  bool gives_ = false;
  std::string prefix_;
};

} // namespace brinell
