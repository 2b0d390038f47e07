// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/ability.hpp>

#include <utility>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include "problems/initializers/away_from_routes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

/// Forwards everything to another cost.
class Forwarding : public SegmentCost {
 public:
  explicit Forwarding(std::shared_ptr<const SegmentCost> cost) : cost_(std::move(cost)) {}
  int dim() const override { return cost_->dim(); }
  const CostTraits& traits() const override { return cost_->traits(); }
  void squared_costs(const AmbientPath& path, std::span<double> q) const override { cost_->squared_costs(path, q); }
  double energy_and_gradient(const AmbientPath& path, const Kernel& kernel, double s0,
                             Eigen::Ref<Points> gradient) const override {
    return cost_->energy_and_gradient(path, kernel, s0, gradient);
  }
  void chain_blocks(const AmbientPath& path, const Kernel& kernel, double s0, HessianKind kind,
                    ChainBlocks& out) const override {
    cost_->chain_blocks(path, kernel, s0, kind, out);
  }
  void residuals(const AmbientPath& path, Points& r, Points* jacobians) const override {
    cost_->residuals(path, r, jacobians);
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override {
    return cost_->line_element(x, v);
  }

 protected:
  std::shared_ptr<const SegmentCost> cost_;
};

/// A cost with every ability that costs can have.
class Able final : public Forwarding, public HasConstantMetric, public ExplainsInfinity, public FollowsDomain {
 public:
  Able() : Forwarding(make_euclidean_cost(3)) {}
  Eigen::MatrixXd metric() const override { return Eigen::Matrix3d::Identity(); }
  std::string why_infinite(const Eigen::VectorXd&, const Eigen::VectorXd&) const override { return "a wall"; }
  std::shared_ptr<const SegmentCost> on(const ConstraintManifold&) const override { return cost_; }
};

/// A decorator that changes nothing.
class Watched : public Forwarding {
 public:
  using Forwarding::Forwarding;
  const SegmentCost* decorated(const std::type_info&) const override { return cost_.get(); }
};

class WatchedAloud final : public Watched, public ExplainsInfinity {
 public:
  using Watched::Watched;
  std::string why_infinite(const Eigen::VectorXd&, const Eigen::VectorXd&) const override { return "my own"; }
};

/// The plane, or with bounds the box that it decorates.
class WatchedBox final : public EmbeddedManifold {
 public:
  explicit WatchedBox(std::shared_ptr<const ConstraintManifold> box)
      : EmbeddedManifold({2, 2, 2}), box_(std::move(box)) {}
  const ConstraintManifold* decorated(const std::type_info&) const override { return box_.get(); }

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd>) const override { return true; }
  void tangent_basis(const Eigen::VectorXd&, Eigen::Ref<Points> basis) const override { basis.setIdentity(); }

 private:
  std::shared_ptr<const ConstraintManifold> box_;
};

class Perhaps {
 public:
  virtual ~Perhaps() = default;
  virtual bool present() const = 0;
};

class Switched final : public Forwarding, public Perhaps {
 public:
  explicit Switched(bool on) : Forwarding(make_euclidean_cost(2)), on_(on) {}
  bool present() const override { return on_; }

 private:
  bool on_;
};

const Eigen::VectorXd kZero = Eigen::Vector3d::Zero(), kOne = Eigen::Vector3d::UnitX();

}  // namespace

TEST_CASE("abilities: a decorated cost keeps every ability, through any number of decorators") {
  const auto able = std::make_shared<const Able>();
  const auto once = std::make_shared<const Watched>(able);
  const Watched twice(once);
  for (const SegmentCost* cost :
       {static_cast<const SegmentCost*>(once.get()), static_cast<const SegmentCost*>(&twice)}) {
    CHECK(find_ability<HasConstantMetric>(cost) == static_cast<const HasConstantMetric*>(able.get()));
    CHECK(find_ability<ExplainsInfinity>(cost) == static_cast<const ExplainsInfinity*>(able.get()));
    CHECK(find_ability<FollowsDomain>(cost) == static_cast<const FollowsDomain*>(able.get()));
    CHECK(reason_for_infinity(*cost, kZero, kOne) == ": a wall");
  }
  CHECK(find_ability<FollowsDomain>(Watched(make_euclidean_cost(3))) == nullptr);
}

TEST_CASE("abilities: the decorator's own come first") {
  CHECK(reason_for_infinity(WatchedAloud(std::make_shared<const Able>()), kZero, kOne) == ": my own");
}

TEST_CASE("abilities: routes that keep away from others say why, and are no lengths under a metric") {
  const Points route = (Points(3, 2) << 0, 1, 0, 0, 0, 0).finished();
  const AwayFromRoutes away(std::make_shared<const Able>(), {route}, 4, 0.3);
  CHECK(reason_for_infinity(away, kZero, kOne) == ": a wall");
  CHECK(find_ability<HasConstantMetric>(away) == nullptr);  // a move costs up to four times its length
  CHECK(find_ability<FollowsDomain>(away) == nullptr);      // on() would forget the routes
}

TEST_CASE("abilities: of a decorated domain") {
  const auto bounded = box(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1));
  const WatchedBox watched(bounded);
  CHECK(find_ability<HasBounds>(watched) == static_cast<const HasBounds*>(bounded.get()));
  CHECK(find_ability<HasChart>(watched) == nullptr);
}

TEST_CASE("abilities: one that depends on how an object was made is there or not, no object has none") {
  CHECK(find_ability<Perhaps>(Switched(true)) != nullptr);
  CHECK(find_ability<Perhaps>(Switched(false)) == nullptr);
  CHECK(find_ability<HasConstantMetric>(static_cast<const SegmentCost*>(nullptr)) == nullptr);
}

}  // namespace leastcost::test
