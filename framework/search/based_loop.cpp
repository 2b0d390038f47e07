// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/based_loop.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "framework/result/find_path_checks.hpp"

namespace leastcost {
namespace {

/// A place on a ring: between column `segment` and the next one.
struct Cut {
  Index segment = 0;
  Eigen::VectorXd x;
};

/// The point of the ring nearest to `base`; on a chart with seams also one turn before, on the universal cover.
Cut nearest_cut(const CoordinatePath& ring, const Eigen::VectorXd& base) {
  const Index n = ring.u.cols(), first = ring.closing.identity() ? 0 : -n;
  Cut best;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = first; i < n; ++i) {
    const Eigen::VectorXd a = ring.column(i), d = ring.column(i + 1) - a;
    const double t = d.squaredNorm() > 0 ? std::clamp((base - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
    const Eigen::VectorXd x = a + t * d;
    if (!((x - base).norm() < least)) continue;
    least = (x - base).norm();
    best = {i, x};
  }
  return best;
}

struct BasedLoop {
  Problem problem;
  FirstPath first;
};

BasedLoop based_loop(const Problem& problem, const FirstPath& ring) {
  const CoordinatePath& closed = ring.path;
  const Index n = closed.u.cols();
  const Cut cut = nearest_cut(closed, problem.source.u);
  const double same = 1e-12 * extent_of(closed.u);
  std::vector<Eigen::VectorXd> points = {problem.source.u};
  std::vector<Site> sites = {problem.source.site};
  const auto add = [&](const Eigen::VectorXd& x, Site site) {
    if ((x - points.back()).norm() <= same) return;
    points.push_back(x);
    sites.push_back(site);
  };
  const auto site_of = [&](Index i) { return closed.site((i + n) % n); };
  add(cut.x, site_of(cut.segment));
  for (Index i = cut.segment + 1; i <= cut.segment + n; ++i) add(closed.column(i), site_of(i));
  add(closed.closing.apply(cut.x), site_of(cut.segment));

  BasedLoop loop{problem, ring};
  loop.problem.ring = false;
  loop.problem.target = {closed.closing.apply(problem.source.u), problem.source.site};
  const bool there = (loop.problem.target.u - points.back()).norm() <= same;
  if (!there || points.size() == 1) {
    points.push_back(loop.problem.target.u);
    sites.push_back(loop.problem.target.site);
  }
  loop.first.path = {Points(closed.u.rows(), static_cast<Index>(points.size())), {}, false};
  for (std::size_t i = 0; i < points.size(); ++i) loop.first.path.u.col(static_cast<Index>(i)) = points[i];
  loop.first.path.u.rightCols(1) = loop.problem.target.u;
  if (!closed.sites.empty()) {
    loop.first.path.sites = sites;
    loop.first.path.sites.back() = loop.problem.target.site;
  }
  return loop;
}

}  // namespace

void cut_at_base(Outcome& out) {
  if (!out.problem.ring || !out.problem.based) return;
  BasedLoop loop = based_loop(out.problem, out.result.first);
  out.problem = std::move(loop.problem);
  out.result.first = std::move(loop.first);
  check(out.problem);
}

void open_based_chain(Outcome& out) {
  const CoordinatePath& chain = out.result.first.path;
  if (!out.problem.ring || !out.problem.based) return;
  if (chain.ring) {
    check_path(out.problem, chain, 1, "the chain");
    return cut_at_base(out);
  }
  if (chain.u.rows() != out.problem.source.u.size() || chain.u.cols() < 3) return;  // place_chain() says so
  out.problem.ring = false;
  out.problem.target = {chain.u.rightCols(1), out.problem.source.site};
  check(out.problem);
}

}  // namespace leastcost
