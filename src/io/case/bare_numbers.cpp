// SPDX-License-Identifier: BSD-3-Clause
#include "case_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Warnings of plain numbers, which are in SI, whose size suggests that N, mm and MPa were meant.
namespace brinell::io
{

namespace
{

/// Numbers of a key that no body has in SI, but many have in another unit. The bounds are those of the plain number.
struct Suspicious
{
  std::string_view ending; ///< of the key
  double least, most;
  std::string_view unit;    ///< unit that was probably meant
  std::string_view because; ///< reason: meaning of the number in SI
};

constexpr std::string_view metals = "metals yield at 10 MPa to 5 GPa";

/// The first one that applies counts.
constexpr std::array suspicious{
    // A modulus of 1e5 to 1e6 Pa is that of a gel; below, the case has the warning soft_material.
    Suspicious{"material.young_modulus", 1e5, 1.3e6, "MPa", "a gel; a steel has about 2.1e11 Pa"},
    Suspicious{"inclusion.young_modulus", 1.0, 2e3, "GPa", "a gel; alumina has about 3.9e11 Pa"},
    Suspicious{"inclusion.young_modulus", 2e3, 1.3e6, "MPa", "a gel; alumina has about 3.9e11 Pa"},
    Suspicious{"hardening.yield_stress", 1.0, 1e4, "MPa", metals},
    Suspicious{"hardening.coefficient", 1.0, 1e4, "MPa", metals},
    Suspicious{"hardening.stress", 1.0, 1e4, "MPa", metals},
    Suspicious{"hardening.saturation", 1.0, 1e4, "MPa", metals},
    Suspicious{"hardening.modulus", 1.0, 1e6, "MPa", "no hardening to speak of"},
    Suspicious{"back_stresses.modulus", 1.0, 1e6, "MPa", "no hardening to speak of"},
    Suspicious{"initial_stress.value", 1.0, 1e4, "MPa", "a stress without effect"},
    Suspicious{"hertz_pressure", 0.0, 20.0, "GPa", "a pressure without effect"},
    Suspicious{"pressure", 1e-3, 1e4, "MPa", "a pressure without effect"},
    Suspicious{"shear_limit", 1.0, 1e4, "MPa", metals},
    Suspicious{"shape.radius", 3.0, 1e4, "mm", "rare in a contact problem"},
    Suspicious{"shape.length", 3.0, 1e4, "mm", "rare in a contact problem"},
    Suspicious{"shape.tip_radius", 1e-2, 1e4, "um", "no tip"},
    Suspicious{"yield_profile.depth", 0.1, 1e4, "mm", "no layer"},
    Suspicious{"initial_stress.depth", 0.1, 1e4, "mm", "no layer"},
    Suspicious{"approach", 1e-2, 1e4, "um", "more than a centimetre"},
    Suspicious{"displacement", 1e-2, 1e4, "um", "more than a centimetre"},
    Suspicious{"mean_gap", 1e-2, 1e4, "um", "more than a centimetre"},
    Suspicious{"grid.spacing", 1e-2, 1e4, "um", "more than a centimetre"},
    Suspicious{"speed", 500.0, 1e6, "mm/s", "faster than sound"},
};

/// Once a modulus was given in MPa, lengths were probably given in mm.
constexpr std::array beside_megapascal{
    Suspicious{"shape.radius", 0.1, 1e4, "mm", "rare in a contact problem"},
    Suspicious{"shape.length", 0.1, 1e4, "mm", "rare in a contact problem"},
    Suspicious{"distance", 0.1, 1e4, "mm", "rare in a contact problem"},
};

/// The largest magnitude of the plain numbers of a value; 0 without any.
double largest_plain(const Raw& raw)
{
  if (const auto* i = std::get_if<std::int64_t>(&raw.value))
    return std::abs(static_cast<double>(*i));
  if (const auto* x = std::get_if<double>(&raw.value))
    return std::isfinite(*x) ? std::abs(*x) : 0.0;
  double largest = 0.0;
  if (const auto* items = std::get_if<std::vector<Raw>>(&raw.value))
    for (const Raw& item : *items)
      largest = std::max(largest, largest_plain(item));
  return largest;
}

template <std::size_t N>
const Suspicious* found_in(const std::array<Suspicious, N>& table, std::string_view key, double number)
{
  for (const Suspicious& one : table)
  {
    const auto at = key.rfind(one.ending);
    const bool is_of_key = at != key.npos && key.find('.', at + one.ending.size()) == key.npos;
    const std::string_view rest = is_of_key ? key.substr(at + one.ending.size()) : std::string_view();
    const bool is_suspicious = number > 0.0 && number >= one.least && number < one.most;
    if (is_suspicious && is_of_key && (rest.empty() || rest == "_x" || rest == "_y"))
      return &one;
  }
  return nullptr;
}

/// Whether an earlier warning is about the same number, or about the yield stress of the same body.
bool is_warned_of(const Case& c, std::string_view key)
{
  const std::string_view body = key.substr(0, key.find('.'));
  return std::any_of(c.warnings.begin(), c.warnings.end(),
                     [&](const Warning& warning)
                     {
                       return warning.text.starts_with(fmt::format("{} ", key)) ||
                              (warning.key == "low_yield" && key.find(".hardening.") != key.npos &&
                               warning.text.starts_with(fmt::format("{}.material", body)));
                     });
}

} // namespace

void warn_of_bare_numbers(const CaseReader& reader, Case& c)
{
  const auto look = [&](const auto& table)
  {
    bool any_pressure = false;
    for (const auto& [key, given] : reader.raw.values)
    {
      const Entry* entry = find_entry(key);
      const bool is_pure = entry && !entry->pure_if.empty() && reader.get_or(entry->pure_if, false);
      if (!entry || entry->of.dimension == dimension::none || is_pure || !reader.has(key))
        continue;
      const double number = largest_plain(given.raw);
      const Suspicious* one = found_in(table, plain_key(key), number);
      if (!one || is_warned_of(c, key))
        continue;
      any_pressure = any_pressure || entry->of.dimension == dimension::pressure;
      warn(c, "bare_number",
           "{} = {} is in {} because it has no unit: {}; it looks like {}, which is written \"{:g} {}\". If SI is "
           "meant, the unit confirms it: \"{:g} {}\"",
           key, shown(given.raw), si_unit(entry->of.dimension), one->because, one->unit, number, one->unit, number,
           si_unit(entry->of.dimension));
    }
    return any_pressure;
  };
  const bool soft = std::any_of(c.warnings.begin(), c.warnings.end(),
                                [](const Warning& warning) { return warning.key == "soft_material"; });
  if (look(suspicious) || soft)
    look(beside_megapascal);
}

} // namespace brinell::io
