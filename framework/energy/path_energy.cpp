// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/path_energy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/has_curvature.hpp>
#include "framework/base/point_text.hpp"
#include "framework/domain/in_parts.hpp"
#include "framework/energy/frame_products.hpp"

namespace leastcost {
namespace {

/// Segments between two looks at the clock: energies and gradients take up to some microseconds each, Hessians up to
/// some ten.
constexpr Index kEnergyPart = 128, kHessianPart = 32;

/// phi(q) = q.
struct SquaredCost {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const { return {q, 1, 0}; }
};

}  // namespace

PathEnergy::PathEnergy(const Problem& problem, double reference_cost, Deadline deadline)
    : problem_(&problem),
      chart_(find_ability<HasChart>(*problem.manifold)),
      s0_(reference_cost),
      deadline_(deadline),
      dims_(problem.manifold->dimensions()) {
  if (!(reference_cost > 0) || !std::isfinite(reference_cost))
    throw InputError("the reference cost must be positive and finite, not " +
                     point_text(Eigen::VectorXd::Constant(1, reference_cost)));
}

PathEnergy::Evaluated& PathEnergy::evaluated(const CoordinatePath& path) {
  const CoordinatePath& last = evaluated_.path;
  const bool same = last.ring == path.ring && last.u.rows() == path.u.rows() && last.u.cols() == path.u.cols() &&
                    last.u == path.u && last.sites == path.sites;
  if (!same) evaluated_ = {std::move(evaluated_.path)};
  if (!same) evaluated_.path = path;
  return evaluated_;
}

AmbientPath PathEnergy::ambient(const CoordinatePath& path) {
  if (!chart_ && !path.ring) return {{path.u.data(), path.u.rows(), path.u.cols()}, path.sites, false};
  Evaluated& here = evaluated(path);
  if (!here.ambient) {
    if (chart_ && wants_slopes_ && !here.jacobians) {
      embed_with_jacobians(*chart_, path, embedded_, jacobians_, deadline_);
      here.jacobians = true;
    } else if (chart_) {
      embed(*chart_, path, embedded_, deadline_);
    }
    const Points& x = chart_ ? embedded_ : path.u;
    if (path.ring) {
      ambient_.resize(x.rows(), x.cols() + 1);
      ambient_ << x, x.col(0);
      ring_sites_ = path.sites;
      if (!ring_sites_.empty()) ring_sites_.push_back(path.sites.front());
    }
    here.ambient = true;
  }
  if (path.ring) return {{ambient_.data(), ambient_.rows(), ambient_.cols()}, ring_sites_, true};
  return {{embedded_.data(), embedded_.rows(), embedded_.cols()}, path.sites, false};
}

const Points& PathEnergy::chart_jacobians(const CoordinatePath& path) {
  Evaluated& here = evaluated(path);
  wants_slopes_ = true;
  if (!here.jacobians && !here.ambient)
    ambient(path);
  else if (!here.jacobians)
    jacobians(*chart_, path, jacobians_, deadline_);
  here.jacobians = true;
  return jacobians_;
}

void PathEnergy::squared_costs(const CoordinatePath& path) {
  Evaluated& here = evaluated(path);
  if (here.costs) return;
  q_.resize(static_cast<std::size_t>(path.segment_count()));
  const AmbientPath x = ambient(path);
  const std::span<double> q = q_;
  in_parts(path.segment_count(), kEnergyPart, deadline_, [&](Index begin, Index count) {
    problem_->cost->squared_costs(x.part(begin, count),
                                  q.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(count)));
  });
  here.costs = true;
}

void PathEnergy::apply_kernel(const CoordinatePath& path) {
  squared_costs(path);
  Evaluated& here = evaluated(path);
  if (here.kernel) return;
  scaled_.resize(q_.size());
  std::transform(q_.begin(), q_.end(), scaled_.begin(), [&](double q) { return q / (s0_ * s0_); });
  phi_.resize(q_.size());
  problem_->kernel->apply(scaled_, phi_);
  here.kernel = true;
}

/// The sum is taken part by part, as that of value_and_gradient() is.
double PathEnergy::value(const CoordinatePath& path) {
  ++counters_.energies;
  apply_kernel(path);
  double energy = 0;
  for (std::size_t begin = 0; begin < phi_.size(); begin += kEnergyPart) {
    double part = 0;
    for (std::size_t i = begin; i < std::min(begin + kEnergyPart, phi_.size()); ++i) part += phi_[i].value;
    energy += part;
  }
  return std::isnan(energy) ? std::numeric_limits<double>::infinity() : energy;
}

double PathEnergy::ambient_gradient(const CoordinatePath& path) {
  Evaluated& here = evaluated(path);
  if (here.gradient) return here.energy;
  const AmbientPath x = ambient(path);
  ambient_gradient_.setZero(dims_.ambient, x.x.cols());
  double energy = 0;
  in_parts(x.segment_count(), kEnergyPart, deadline_, [&](Index begin, Index count) {
    part_gradient_.resize(dims_.ambient, count + 1);
    energy += problem_->cost->energy_and_gradient(x.part(begin, count), *problem_->kernel, s0_, part_gradient_);
    ambient_gradient_.middleCols(begin, count + 1) += part_gradient_;
  });
  // The closing column of a ring is its first point again.
  if (path.ring) ambient_gradient_.col(0) += ambient_gradient_.col(x.x.cols() - 1);
  here.energy = energy;
  here.gradient = true;
  return energy;
}

double PathEnergy::value_and_gradient(const CoordinatePath& path, Points& gradient) {
  ++counters_.gradients;
  const double energy = ambient_gradient(path);
  const Index first = path.free_begin(), n = path.free_count();
  if (chart_) {
    const int d = dims_.coordinate;
    const Points& j = chart_jacobians(path);
    gradient.resize(d, n);
    with_frame_size(dims_.ambient, d, [&](auto size) {
      for (Index i = 0; i < n; ++i)
        gradient.col(i).noalias() =
            matrix_at(j, size, d, first + i).transpose().lazyProduct(ambient_gradient_.col(first + i));
    });
  } else {
    gradient = ambient_gradient_.middleCols(first, n);
  }
  return gradient.allFinite() ? energy : std::numeric_limits<double>::infinity();
}

void PathEnergy::residuals(const CoordinatePath& path, Points& r, Points* jacobians) {
  ++(jacobians != nullptr ? counters_.gradients : counters_.energies);
  const AmbientPath x = ambient(path);
  Points part_r, part_jacobians;
  in_parts(x.segment_count(), kEnergyPart, deadline_, [&](Index begin, Index count) {
    problem_->cost->residuals(x.part(begin, count), part_r, jacobians != nullptr ? &part_jacobians : nullptr);
    const Index width = 2 * dims_.ambient;
    if (begin == 0) r.resize(part_r.rows(), x.segment_count());
    if (begin == 0 && jacobians != nullptr) jacobians->resize(part_r.rows(), width * x.segment_count());
    r.middleCols(begin, count) = part_r;
    if (jacobians != nullptr) jacobians->middleCols(width * begin, width * count) = part_jacobians;
  });
  if (jacobians == nullptr || !chart_) return;
  const Points& j = chart_jacobians(path);
  const int d = dims_.ambient, k = dims_.coordinate;
  Points in_chart(r.rows(), 2 * k * r.cols());
  for (Index i = 0; i < r.cols(); ++i) {
    const Index next = (i + 1) % path.u.cols();  // the last segment of a ring ends at an image of its first point
    in_chart.middleCols(2 * k * i, k) = jacobians->middleCols(2 * d * i, d) * j.middleCols(k * i, k);
    in_chart.middleCols(2 * k * i + k, k) = jacobians->middleCols(2 * d * i + d, d) * j.middleCols(k * next, k);
  }
  *jacobians = std::move(in_chart);
}

void PathEnergy::metrics(const CoordinatePath& path, Points& g) {
  ++counters_.energies;
  static const KernelOf<SquaredCost> kernel;
  const AmbientPath x = ambient(path);
  if (chart_) chart_jacobians(path);
  const int d = dims_.ambient, k = dims_.coordinate;
  const Index columns = path.u.cols();
  g.resize(k, k * columns);
  const bool at_rest = problem_->cost->traits().quadratic_at_rest;
  constexpr double kShort = 1e-4;  // of a segment: what a Finsler cost has for a metric, it has in a direction
  Points three(d, 3);
  for (Index i = 0; i < columns; ++i) {
    if (i % kHessianPart == 0) look_at_clock(deadline_);
    three.colwise() = x.x.col(i);
    if (!at_rest) {
      const Index begin = std::min(i, x.segment_count() - 1);
      three.col(0) -= kShort * (x.x.col(begin + 1) - x.x.col(begin));
    }
    // A move from x to x: half its second derivative in the free end, which is the middle of three (the others are
    // constants).
    problem_->cost->chain_blocks({{three.data(), d, 3}, {}, false}, kernel, 1, HessianKind::exact, blocks_);
    const Points ambient_metric = blocks_.blocks.block(d, d, d, d) / 2;
    if (chart_)
      g.middleCols(k * i, k) =
          jacobians_.middleCols(k * i, k).transpose() * ambient_metric * jacobians_.middleCols(k * i, k);
    else
      g.middleCols(k * i, k) = ambient_metric;
  }
}

void PathEnergy::to_tangent(const Frames& frames, const Points& vectors, Eigen::VectorXd& tangent) const {
  const int k = dims_.tangent;
  tangent.resize(k * vectors.cols());
  if (frames.identity) {
    tangent = vectors.reshaped();
    return;
  }
  for (Index i = 0; i < vectors.cols(); ++i) {
    tangent.segment(k * i, k).noalias() = frames.bases.middleCols(k * i, k).transpose().lazyProduct(vectors.col(i));
    const int blocked = frames.blocked[static_cast<std::size_t>(i)];
    tangent.segment(k * i + k - blocked, blocked).setZero();
  }
}

void PathEnergy::from_tangent(const Frames& frames, const Eigen::VectorXd& tangent, Points& vectors) const {
  const int k = dims_.tangent;
  const Index n = tangent.size() / k;
  vectors.resize(dims_.coordinate, n);
  if (frames.identity) {
    vectors.reshaped() = tangent;
    return;
  }
  for (Index i = 0; i < n; ++i)
    vectors.col(i).noalias() = frames.bases.middleCols(k * i, k).lazyProduct(tangent.segment(k * i, k));
}

bool PathEnergy::has_exact_hessian() const {
  return problem_->kernel->strictly_convex() && problem_->manifold->shape() != Shape::polyhedral;
}

void PathEnergy::chain_hessian(const CoordinatePath& path, const Points& gradient, const Frames& frames,
                               HessianKind kind, ChainSystem& system) {
  ++counters_.hessians;
  if (kind == HessianKind::exact && !has_exact_hessian()) kind = HessianKind::gauss_newton;
  const AmbientPath x = ambient(path);
  const int d = dims_.ambient, k = dims_.tangent;
  const Index n = path.free_count(), segments = path.segment_count();
  system.resize(k, n, path.ring);
  system.set_zero();
  const bool in_coordinates = frames.identity && frames.lifted.size() == 0;
  const Points& bases = frames.lifted.size() > 0 ? frames.lifted : frames.bases;
  // Among obstacles few points have a frame of their own.
  std::vector<char> plain;
  if (!in_coordinates && d == k) {
    plain.resize(static_cast<std::size_t>(n));
    with_frame_size(d, k, [&](auto size) {
      for (Index i = 0; i < n; ++i) plain[static_cast<std::size_t>(i)] = is_plain(bases, size, k, i) ? 1 : 0;
    });
  }
  const auto is_plain_at = [&](Index i) {
    return in_coordinates || (!plain.empty() && plain[static_cast<std::size_t>(i)] != 0);
  };
  in_parts(segments, kHessianPart, deadline_, [&](Index begin, Index count) {
    problem_->cost->chain_blocks(x.part(begin, count), *problem_->kernel, s0_, kind, blocks_);
    with_frame_size(d, k, [&](auto size) {
      const auto add = [&](Index i, Index j, Index row, Index column, Eigen::Block<Points> out) {
        using Square = Eigen::Matrix<double, size.kRows, size.kRows>;
        const Index stride = blocks_.blocks.rows();
        const Eigen::Map<const Square, 0, Eigen::OuterStride<>> h(blocks_.blocks.data() + stride * column + row, d, d,
                                                                  Eigen::OuterStride<>(stride));
        if (is_plain_at(i) && is_plain_at(j))
          add_plain(size, h, out);
        else
          add_in_frames(bases, size, k, i, j, h, out);
      };
      for (Index s = begin; s < begin + count; ++s) {
        const Index a = s - path.free_begin();                       // free point at the segment's start
        const Index b = path.ring && s + 1 == segments ? 0 : a + 1;  // and at its end
        const Index c = 2 * d * (s - begin);
        if (a >= 0) add(a, a, 0, c, system.diagonal(a));
        if (b < n) add(b, b, d, c + d, system.diagonal(b));
        if (a >= 0 && b < n) add(a, b, 0, c + d, system.coupling(a));
      }
    });
  });
  if (kind == HessianKind::exact && chart_)
    add_chart_curvature(path, frames, system);
  else if (kind == HessianKind::exact && problem_->manifold->shape() == Shape::smooth)
    add_curvature(path, gradient, frames, system);
  block_directions(frames, system);
}

/// The curvature of the domain in the Hessian of E along the retraction R: g' d2R(t, t), which for the nearest-point
/// retraction is -P (sum_j lambda_j Hess F_j) P (docs/numerics.md Sec. 3.3). From second differences of g'R with g held
/// fixed, two retractions of the whole path per pair of directions, so it works for every domain; those that know how
/// they bend (HasCurvature) are asked.
void PathEnergy::add_curvature(const CoordinatePath& path, const Points& gradient, const Frames& frames,
                               ChainSystem& system) {
  const int k = dims_.tangent;
  const Index n = path.free_count(), first = path.free_begin();
  if (const auto* known = find_ability<HasCurvature>(*problem_->manifold)) {
    Points bend;
    Eigen::VectorXd slope;
    with_frame_size(dims_.coordinate, k, [&](auto size) {
      for (Index i = 0; i < n; ++i) {
        if (i % kHessianPart == 0) look_at_clock(deadline_);
        slope = gradient.col(i);
        if (!known->bend(path, first + i, slope, bend)) continue;
        add_in_frames(frames.bases, size, k, i, i, square_of(bend, size), system.diagonal(i));
      }
    });
    return;
  }
  const double extent = extent_of(path.u);
  const double h = 3e-4 * extent;  // eps^(1/4): rounding and truncation of a second difference balance
  if (!(h > 0)) return;
  const auto move = [&](CoordinatePath& to) {
    ++counters_.projections;
    leastcost::retract(*problem_->manifold, path, step_, to, deadline_, true);
  };
  const auto differences = [&](int p, int q) {
    step_.resize(dims_.coordinate, n);
    for (Index i = 0; i < n; ++i) {
      step_.col(i) = h * frames.bases.col(k * i + p);
      if (q != p) step_.col(i) += h * frames.bases.col(k * i + q);
    }
    move(plus_);
    step_ = -step_;
    move(minus_);
    const auto bend = (plus_.u + minus_.u - 2 * path.u).middleCols(first, n);
    return Eigen::VectorXd((gradient.cwiseProduct(bend)).colwise().sum().transpose() / (h * h));
  };
  Points pure(n, k);
  for (int p = 0; p < k; ++p) pure.col(p) = differences(p, p);
  for (int p = 0; p < k; ++p) {
    for (Index i = 0; i < n; ++i) system.diagonal(i)(p, p) += pure(i, p);
    for (int q = 0; q < p; ++q) {
      const Eigen::VectorXd mixed = (differences(p, q) - pure.col(p) - pure.col(q)) / 2;
      for (Index i = 0; i < n; ++i) {
        system.diagonal(i)(p, q) += mixed[i];
        system.diagonal(i)(q, p) += mixed[i];
      }
    }
  }
}

/// A chart's retraction is addition: what bends is the embedding, and its second derivatives are at hand.
void PathEnergy::add_chart_curvature(const CoordinatePath& path, const Frames& frames, ChainSystem& system) {
  const int d = dims_.coordinate;
  const Index n = path.free_count(), first = path.free_begin();
  ambient_gradient(path);
  curvatures(*chart_, path, ambient_gradient_, step_, deadline_);
  for (Index i = 0; i < n; ++i) {
    const auto h = step_.middleCols(d * (first + i), d);
    if (frames.identity && d == 2) {
      double* const out = system.diagonal(i).data();
      for (int e = 0; e < 4; ++e) out[e] += step_.data()[4 * (first + i) + e];
    } else if (frames.identity) {
      system.diagonal(i) += h;
    } else {
      const auto basis = frames.bases.middleCols(d * i, d);
      system.diagonal(i).noalias() += basis.transpose() * h.lazyProduct(basis);
    }
  }
}

void PathEnergy::block_directions(const Frames& frames, ChainSystem& system) const {
  if (frames.identity) return;
  const int k = dims_.tangent;
  const Index n = system.count();
  for (Index i = 0; i < n; ++i) {
    for (int p = k - frames.blocked[static_cast<std::size_t>(i)]; p < k; ++p) {
      Eigen::Block<Points> a = system.diagonal(i);
      a.row(p).setZero();
      a.col(p).setZero();
      a(p, p) = 1;
      system.coupling(i).row(p).setZero();
      system.coupling(i == 0 ? n - 1 : i - 1).col(p).setZero();
    }
  }
}

bool PathEnergy::factor(ChainSystem& system) {
  ++counters_.linear_solves;
  return system.factor(deadline_);
}

void PathEnergy::solve(const ChainSystem& system, Eigen::VectorXd& x) {
  ++counters_.linear_solves;
  look_at_clock(deadline_);
  system.solve(x);
}

void PathEnergy::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) {
  ++counters_.projections;
  leastcost::retract(*problem_->manifold, from, step, to, deadline_);
}

void PathEnergy::count(const Counters& work) { counters_ = counters_ + work; }

Eigen::VectorXd PathEnergy::costs(const CoordinatePath& path) {
  squared_costs(path);
  return Eigen::Map<const Eigen::VectorXd>(q_.data(), static_cast<Index>(q_.size())).cwiseSqrt();
}

double PathEnergy::cost(const CoordinatePath& path) {
  squared_costs(path);
  double sum = 0;
  for (const double q : q_) sum += std::sqrt(q);
  return sum;
}

double PathEnergy::scale(const CoordinatePath& path) {
  apply_kernel(path);
  double sum = 0;
  for (std::size_t i = 0; i < scaled_.size(); ++i) sum += 2 * phi_[i].d1 * scaled_[i];
  return sum;
}

}  // namespace leastcost
