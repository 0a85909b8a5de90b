// SPDX-License-Identifier: BSD-3-Clause
#include "brinell/contact/elastic_contact.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/sharing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brinell::contact
{

ElasticContact::ElasticContact(const halfspace::SurfaceCompliance& compliance)
    : compliance_(compliance), scratch_(compliance.make_scratch()), direction_(compliance.grid().size()),
      image_(compliance.grid().size()), displacement_(compliance.grid().size())
{
}

namespace
{

bool touches(std::span<const double> pressure)
{
  return std::any_of(pressure.begin(), pressure.end(), [](double p) { return p > 0.0; });
}

/// A sum over the cells under pressure, and how many they are.
struct Under
{
  double sum = 0.0, count = 0.0;
  Under& operator+=(const Under& other)
  {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

/// The larger of two; a NaN in either stays.
double larger(double a, double b)
{
  return b <= a || std::isnan(a) ? a : b;
}

/// Both halves of the complementarity condition, and the squares of the gap under pressure.
struct Errors
{
  double squares = 0.0, gap = 0.0, penetration = 0.0;
  Errors& operator+=(const Errors& other)
  {
    squares += other.squares;
    gap = larger(gap, other.gap);
    penetration = larger(penetration, other.penetration);
    return *this;
  }
};

/// Sums over the cells of a direction of descent.
struct Slopes
{
  double descent = 0.0;   ///< gap times direction
  double curvature = 0.0; ///< image times direction
  double direction = 0.0;
  Under image;
  Slopes& operator+=(const Slopes& other)
  {
    descent += other.descent;
    curvature += other.curvature;
    direction += other.direction;
    image += other.image;
    return *this;
  }
};

/// Without load the surfaces just touch.
Report touching(std::span<const double> distance, std::span<double> pressure, std::span<double> gap)
{
  Report report;
  report.converged = true;
  report.approach = *std::min_element(distance.begin(), distance.end());
  std::fill(pressure.begin(), pressure.end(), 0.0);
  std::transform(distance.begin(), distance.end(), gap.begin(), [&](double d) { return d - report.approach; });
  return report;
}

} // namespace

/// A pressure to begin with: the guess, or if there is none the cells that overlap, at the stiffness of a single cell; under a
/// load that has not pressed anything yet, the cell that touches first.
void ElasticContact::start(std::span<const double> distance, const Drive& drive, std::span<double> pressure)
{
  for (double& p : pressure)
    p = std::max(p, 0.0);
  const bool load_given = drive.kind == Drive::Kind::load;
  if (!touches(pressure))
  {
    const double stiffness = 1.0 / compliance_.largest();
    if (load_given)
      pressure[static_cast<std::size_t>(std::min_element(distance.begin(), distance.end()) - distance.begin())] = 1.0;
    else
      for (std::size_t i = 0; i < distance.size(); ++i)
        pressure[i] = std::max(0.0, drive.value - distance[i]) * stiffness;
  }
  if (load_given)
    scale_to_load(drive.value, std::accumulate(pressure.begin(), pressure.end(), 0.0), pressure);
}

ElasticContact::Step& ElasticContact::Step::operator+=(const Step& other)
{
  cut = cut || other.cut;
  added = added || other.added;
  sum += other.sum;
  return *this;
}

/// The load made what it should be; `sum` is that of the pressure. The displacement keeps pace.
void ElasticContact::scale_to_load(double load, double sum, std::span<double> pressure)
{
  const double factor = load / (sum * compliance_.grid().cell_area());
  for_pieces(pressure.size(),
             [&](std::size_t first, std::size_t last)
             {
               for (std::size_t i = first; i < last; ++i)
               {
                 pressure[i] *= factor;
                 displacement_[i] *= factor;
               }
             });
}

/// Gap and errors of the displacement that is known.
ElasticContact::State ElasticContact::settle(std::span<const double> distance, const Drive& drive,
                                             std::span<const double> pressure, std::span<double> gap) const
{
  const std::size_t cells = gap.size();
  const double* p = pressure.data();
  double* g = gap.data();
  State state;
  state.report.approach = drive.value;
  if (drive.kind == Drive::Kind::load)
    state.report.approach = sum_of_pieces(cells,
                                          [&](std::size_t first, std::size_t last)
                                          {
                                            double sum = 0.0;
                                            double count = 0.0;
#pragma omp simd reduction(+ : sum, count)
                                            for (std::size_t i = first; i < last; ++i)
                                            {
                                              sum += p[i] > 0.0 ? displacement_[i] + distance[i] : 0.0;
                                              count += p[i] > 0.0 ? 1.0 : 0.0;
                                            }
                                            return Under{sum, count};
                                          })
                                .mean();
  const double approach = state.report.approach;
  const Errors errors = sum_of_pieces(cells,
                                      [&](std::size_t first, std::size_t last)
                                      {
                                        double squares = 0.0;
                                        double sum = 0.0; // is NaN if any gap is
                                        double gap_error = 0.0;
                                        double penetration = 0.0;
#pragma omp simd reduction(+ : squares, sum) reduction(max : gap_error, penetration)
                                        for (std::size_t i = first; i < last; ++i)
                                        {
                                          const double value = displacement_[i] + distance[i] - approach;
                                          const double under = p[i] > 0.0 ? value : 0.0;
                                          const double outside = p[i] > 0.0 ? 0.0 : -value;
                                          g[i] = value;
                                          sum += value;
                                          squares += under * under;
                                          gap_error = std::max(gap_error, std::abs(under));
                                          penetration = std::max(penetration, outside);
                                        }
                                        const double none = std::isnan(sum) ? sum : 0.0;
                                        return Errors{squares, gap_error + none, penetration + none};
                                      });
  state.squares = errors.squares;
  state.report.gap_error = errors.gap;
  state.report.penetration = errors.penetration;
  return state;
}

/// Next direction of descent, and its image.
/// @returns the step along it that makes the energy smallest
double ElasticContact::descend(double beta, bool load_given, std::span<const double> pressure,
                               std::span<const double> gap)
{
  const double* p = pressure.data();
  const double* g = gap.data();
  double* d = direction_.data();
  for_pieces(gap.size(),
             [&](std::size_t first, std::size_t last)
             {
#pragma omp simd
               for (std::size_t i = first; i < last; ++i)
                 d[i] = p[i] > 0.0 ? g[i] + beta * d[i] : 0.0;
             });
  compliance_.apply(direction_, image_, scratch_);
  const double* image = image_.data();
  const Slopes slopes = sum_of_pieces(gap.size(),
                                      [&](std::size_t first, std::size_t last)
                                      {
                                        double descent = 0.0;
                                        double curvature = 0.0;
                                        double direction = 0.0;
                                        double sum = 0.0;
                                        double count = 0.0;
#pragma omp simd reduction(+ : descent, curvature, direction, sum, count)
                                        for (std::size_t i = first; i < last; ++i)
                                        {
                                          descent += g[i] * d[i];
                                          curvature += image[i] * d[i];
                                          direction += d[i];
                                          sum += p[i] > 0.0 ? image[i] : 0.0;
                                          count += p[i] > 0.0 ? 1.0 : 0.0;
                                        }
                                        return Slopes{descent, curvature, direction, {sum, count}};
                                      });
  const double mean = load_given ? slopes.image.mean() : 0.0; // the approach takes it up
  const double curvature = slopes.curvature - mean * slopes.direction;
  return curvature > 0.0 ? slopes.descent / curvature : 0.0;
}

/// Takes the step, with the displacement as far as the image gives it. Steps past zero pressure are cut; cells that overlap
/// come (back) into contact.
ElasticContact::Step ElasticContact::advance(double step, double relaxation, std::span<const double> gap,
                                             std::span<double> pressure)
{
  double* p = pressure.data();
  const double* g = gap.data();
  return sum_of_pieces(gap.size(),
                       [&](std::size_t first, std::size_t last)
                       {
                         double sum = 0.0;
                         int cut = 0;
                         int added = 0;
#pragma omp simd reduction(+ : sum, cut, added)
                         for (std::size_t i = first; i < last; ++i)
                         {
                           const double moved = p[i] > 0.0 ? p[i] - step * direction_[i] : 0.0;
                           const bool is_cut = p[i] > 0.0 && !(moved > 0.0);
                           const bool is_added = !(moved > 0.0) && g[i] < 0.0;
                           cut += is_cut ? 1 : 0;
                           added += is_added ? 1 : 0;
                           p[i] = is_added ? -relaxation * g[i] : std::max(0.0, moved);
                           sum += p[i];
                           displacement_[i] -= step * image_[i];
                         }
                         return Step{cut > 0, added > 0, sum};
                       });
}

Report ElasticContact::solve(std::span<const double> distance, const Drive& drive, double tolerance, int max_iterations,
                             std::span<double> pressure, std::span<double> gap, const std::function<bool()>& wants_stop)
{
  const bool load_given = drive.kind == Drive::Kind::load;
  if (load_given && !(drive.value > 0.0))
    return touching(distance, pressure, gap);
  start(distance, drive, pressure);
  std::fill(direction_.begin(), direction_.end(), 0.0);
  const auto is_good = [&](const Report& r)
  { return r.gap_error <= tolerance && r.penetration <= tolerance && std::isfinite(r.approach); };
  constexpr int few = 8;   // iterations between questions whether to stop
  constexpr int many = 32; // and at most between two products with the pressure itself: rounding does not pile up
  int followed = many;     // iterations since the last of these
  bool conjugate = false;
  double squares_before = 1.0;
  for (int iteration = 0;; ++iteration)
  {
    if (wants_stop && iteration % few == 0 && wants_stop())
      throw Interrupted();
    const bool is_last = iteration == max_iterations;
    State state;
    if (followed < many && !is_last)
      state = settle(distance, drive, pressure, gap);
    if (followed >= many || is_last || (followed > 0 && is_good(state.report)))
    {
      compliance_.apply(pressure, displacement_, scratch_);
      followed = 0;
      state = settle(distance, drive, pressure, gap);
    }
    state.report.iterations = iteration;
    state.report.converged = is_good(state.report);
    if (state.report.converged || is_last)
      return state.report;

    const double step = descend(conjugate ? state.squares / squares_before : 0.0, load_given, pressure, gap);
    squares_before = state.squares;
    const double relaxation = step > 0.0 ? step : 1.0 / compliance_.longest_wave();
    Step done = advance(step, relaxation, gap, pressure);
    conjugate = !done.added; // whatever comes into contact restarts the directions
    followed = done.cut || done.added ? many : followed + 1;
    if (load_given && done.sum > 0.0)
      scale_to_load(drive.value, done.sum, pressure);
    else if (load_given) // everything was cut: begin anew
    {
      start(distance, drive, pressure);
      conjugate = false;
    }
  }
}

} // namespace brinell::contact
