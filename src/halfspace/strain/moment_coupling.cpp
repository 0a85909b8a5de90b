// SPDX-License-Identifier: BSD-3-Clause
#include "moment_coupling.hpp"

#include <algorithm>
#include <array>

namespace brinell::halfspace
{

using images::factorial;
using images::strains;
using images::stresses;

MomentCoupling::MomentCoupling(int depths, int degree) : depths_(depths)
{
  const auto count = static_cast<std::size_t>(monomial(0, degree) + 1);
  share_.resize(count);
  sign_.resize(count);
  for (int a = 0; a <= degree; ++a)
    for (int b = 0; a + b <= degree; ++b)
    {
      const auto place = static_cast<std::size_t>(monomial(a, b));
      share_[place] = 1.0 / (factorial(a) * factorial(b));
      sign_[place] = (a + b) % 2 == 0 ? 1.0 : -1.0;
    }
}

void MomentCoupling::add(int c, int e, const images::Powers& power, double factor, const Matrix& value)
{
  const auto [a, b] = power;
  const std::size_t first = value_.size();
  terms_.push_back({c, e, a, b, first});
  value_.resize(first + static_cast<std::size_t>(depths_ * parts()), Lanes{});
  const double scale = factor * factorial(a) * factorial(b);
  for (int j = 0; j < depths_; ++j)
    for (int i = 0; i < depths_; ++i)
      value_[first + static_cast<std::size_t>(j * parts() + i / lane_count)][i % lane_count] = scale * value(i, j);
}

MomentCoupling::Work MomentCoupling::make_work() const
{
  return {std::vector<double>(static_cast<std::size_t>(strains * monomials() * depths_)),
          AlignedVector<Lanes>(static_cast<std::size_t>(stresses * monomials() * parts()))};
}

void MomentCoupling::multiply(const double* strain, bool is_mirrored, int components, Work& work, double* stress) const
{
  const auto of = [this](int component, int depth)
  { return static_cast<std::ptrdiff_t>(component * depths_ + depth) * monomials(); };
  for (int e = 0; e < strains; ++e)
    for (int q = 0; q < depths_; ++q)
      for (std::size_t p = 0; p < share_.size(); ++p)
        work.strain[(static_cast<std::size_t>(e) * share_.size() + p) * static_cast<std::size_t>(depths_) +
                    static_cast<std::size_t>(q)] = sign_[p] * share_[p] * (strain + of(e, q))[p];
  std::fill(work.stress.begin(), work.stress.end(), Lanes{});
  for (const Term& term : terms_)
    if (term.c < components)
      add_term(term, is_mirrored, work);
  for (int c = 0; c < components; ++c)
    for (int q = 0; q < depths_; ++q)
      for (std::size_t p = 0; p < share_.size(); ++p)
        (stress + of(c, q))[p] =
            share_[p] *
            work.stress[(static_cast<std::size_t>(c) * share_.size() + p) * static_cast<std::size_t>(parts()) +
                        static_cast<std::size_t>(q / lane_count)][q % lane_count];
}

/// Calls add(moment of the strain, moment of the stress), each at all depths, for all pairs of moments that a term couples.
template <typename Add>
void MomentCoupling::for_products(const Term& term, bool is_mirrored, Work& work, const Add& add) const
{
  const int step = is_mirrored ? 2 : 1;
  const int first = is_mirrored ? images::odd_in_y[static_cast<std::size_t>(term.c)] : 0;
  const double* strain = work.strain.data() + static_cast<std::ptrdiff_t>(term.e * monomials()) * depths_;
  Lanes* stress = work.stress.data() + static_cast<std::ptrdiff_t>(term.c * monomials()) * parts();
  for (int a = 0; a <= term.a; ++a)
    for (int b = first; b <= term.b; b += step)
      add(strain + static_cast<std::ptrdiff_t>(monomial(term.a - a, term.b - b)) * depths_,
          stress + static_cast<std::ptrdiff_t>(monomial(a, b)) * parts());
}

/// For few depths: the kernel stays in registers.
template <std::size_t depths>
void MomentCoupling::add_short_term(const Term& term, bool is_mirrored, Work& work) const
{
  constexpr std::size_t parts = (depths + lane_count - 1) / lane_count;
  std::array<Lanes, parts * depths> value;
  std::copy_n(value_.data() + term.value, parts * depths, value.begin());
  for_products(term, is_mirrored, work,
               [&](const double* from, Lanes* to)
               {
#pragma GCC unroll 4
                 for (std::size_t part = 0; part < parts; ++part)
                 {
                   Lanes sum = to[part];
#pragma GCC unroll 8
                   for (std::size_t q = 0; q < depths; ++q)
                     sum += value[parts * q + part] * from[q];
                   to[part] = sum;
                 }
               });
}

void MomentCoupling::add_term(const Term& term, bool is_mirrored, Work& work) const
{
  switch (depths_)
  {
  case 5:
    return add_short_term<5>(term, is_mirrored, work);
  case 6:
    return add_short_term<6>(term, is_mirrored, work);
  case 7:
    return add_short_term<7>(term, is_mirrored, work);
  case 8:
    return add_short_term<8>(term, is_mirrored, work);
  default:
    break;
  }
  for_products(term, is_mirrored, work,
               [&](const double* from, Lanes* to)
               {
                 const Lanes* value = value_.data() + term.value;
                 for (int q = 0; q < depths_; ++q)
                   for (int part = 0; part < parts(); ++part)
                     to[part] += *value++ * from[q];
               });
}

} // namespace brinell::halfspace
