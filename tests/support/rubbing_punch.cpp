// SPDX-License-Identifier: BSD-3-Clause
#include "rubbing_punch.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>
#include <vector>

namespace brinell::test
{

namespace
{

constexpr double pi = std::numbers::pi;

/// int ds/(x - s) from a to b
double of_constant(double x, double a, double b)
{
  return std::log(std::abs((x - a) / (x - b)));
}

/// int N(s)/(x - s) ds from a to b, of N that rises from 0 at a to 1 at b
double of_rise(double x, double a, double b)
{
  return ((x - a) * of_constant(x, a, b) - (b - a)) / (b - a);
}

double of_fall(double x, double a, double b)
{
  return of_constant(x, a, b) - of_rise(x, a, b);
}

/// The punch with the edge of its stick at c. Unknown are the pressure of all elements and the shear at the nodes within c; the pressure
/// is even, the shear odd.
class Punch
{
public:
  Punch(double stick, double of_materials, double coefficient, int elements)
      : c_(stick), beta_(of_materials), f_(coefficient), sticking_(elements), size_(3 * elements)
  {
    for (int i = 0; i <= elements; ++i)
      node_.push_back(c_ * std::sin(0.5 * pi * i / elements));
    for (int i = 1; i <= 2 * elements; ++i)
      node_.push_back(c_ + (1.0 - c_) * 0.5 * (1.0 - std::cos(0.5 * pi * i / elements)));
  }

  /// The equations of the shear are one more than its unknowns, as it may not have a singularity at c. @returns by how much all points
  /// that stick would have to be stretched, in addition, to fulfil them: 0 at the stick of this friction
  [[nodiscard]] double misfit() const
  {
    const Eigen::Index last = size_ + sticking_ - 1;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(last + 1, last + 1);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(last + 1);
    for (int i = 0; i < size_; ++i)
    {
      const double x = collocation(i);
      if (i + 1 < size_)
      {
        for (int j = 0; j < size_; ++j)
          matrix(i, j) = (of_constant(x, node(j), node(j + 1)) + of_constant(x, -node(j + 1), -node(j))) / pi;
        matrix.row(i) -= beta_ * shear_of_element(i);
      }
      else // The solution is that under a load.
      {
        for (int j = 0; j < size_; ++j)
          matrix(i, j) = 2.0 * (node(j + 1) - node(j));
        rhs(i) = 1.0;
      }
      if (i < sticking_)
      {
        matrix.row(size_ + i) = stretch_by_shear(x);
        matrix(size_ + i, i) += beta_;
        matrix(size_ + i, last) = 1.0;
      }
    }
    return Eigen::VectorXd(matrix.partialPivLu().solve(rhs))(last);
  }

private:
  [[nodiscard]] double node(int i) const { return node_[static_cast<std::size_t>(i)]; }
  /// In the middle of an element, and where it slips there where pressure and shear of the element together do nothing.
  [[nodiscard]] double collocation(int i) const
  {
    const double share = i < sticking_ ? 0.5 : 1.0 / (1.0 + std::exp(-pi * beta_ * f_));
    return node(i) + share * (node(i + 1) - node(i));
  }
  /// The shear at a node, in the unknowns.
  [[nodiscard]] Eigen::RowVectorXd shear_at(int i) const
  {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size_ + sticking_);
    if (i == sticking_)
      row(i - 1) = row(i) = 0.5 * f_;
    else if (i > 0)
      row(size_ + i - 1) = 1.0;
    return row;
  }
  [[nodiscard]] Eigen::RowVectorXd shear_of_element(int i) const
  {
    if (i < sticking_)
      return 0.5 * (shear_at(i) + shear_at(i + 1));
    return f_ * Eigen::RowVectorXd::Unit(size_ + sticking_, i);
  }
  [[nodiscard]] Eigen::RowVectorXd stretch_by_shear(double x) const
  {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size_ + sticking_);
    for (int j = 0; j < size_; ++j)
    {
      const double a = node(j), b = node(j + 1);
      if (j < sticking_)
        row += ((of_fall(x, a, b) - of_rise(x, -b, -a)) * shear_at(j) +
                (of_rise(x, a, b) - of_fall(x, -b, -a)) * shear_at(j + 1)) /
               pi;
      else
        row(j) += f_ * (of_constant(x, a, b) - of_constant(x, -b, -a)) / pi;
    }
    return row;
  }

  double c_, beta_, f_;
  int sticking_, size_;
  std::vector<double> node_;
};

double stick(double beta, double friction, int elements)
{
  double low = 0.01, high = 0.999; // of which the points stick that may not, and slip
  for (int i = 0; i < 30; ++i)
  {
    const double c = 0.5 * (low + high);
    (Punch(c, beta, friction, elements).misfit() > 0.0 ? low : high) = c;
  }
  return low;
}

} // namespace

double stick_of_a_punch(double beta, double friction)
{
  return 2.0 * stick(beta, friction, 48) - stick(beta, friction, 24);
}

} // namespace brinell::test
