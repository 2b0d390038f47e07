// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/domain_space.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <unordered_set>
#include <utility>

namespace leastcost {
namespace {

namespace ob = ompl::base;

constexpr int kTries = 100;           ///< of a sample that has no nearest point, or one beyond the box
constexpr double kOnDomain = 1e-9;    ///< relative to the coordinates
constexpr int kPartsOfMove = 8;       ///< of a move that is blocked, looked at from its end
constexpr double kResolution = 1e-2;  ///< of the extent; what is between two states our validator does not ask for

Eigen::Map<Eigen::VectorXd> values(const ob::State* state, Index rows) {
  return {state->as<ob::RealVectorStateSpace::StateType>()->values, rows};
}

/// Of at most two coordinates: they themselves. OMPL 1.5 has the same, which takes their size in bytes for their
/// number.
class Coordinates final : public ob::ProjectionEvaluator {
 public:
  explicit Coordinates(const ob::StateSpace* space) : ob::ProjectionEvaluator(space) {}
  unsigned getDimension() const override { return space_->getDimension(); }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> out) const override {
    out = values(state, static_cast<Index>(getDimension()));
  }
};

/// Coordinates, with what lies between two states brought onto the domain.
class DomainSpace final : public ob::RealVectorStateSpace {
 public:
  DomainSpace(const SampleBox& box, bool flat, ClearLines& lines)
      : ob::RealVectorStateSpace(static_cast<unsigned>(box.lower.size())), flat_(flat), lines_(lines) {
    ob::RealVectorBounds bounds(getDimension());
    for (Index i = 0; i < box.lower.size(); ++i) {
      bounds.setLow(static_cast<unsigned>(i), box.lower[i]);
      bounds.setHigh(static_cast<unsigned>(i), box.upper[i]);
    }
    setBounds(bounds);
    setName("the domain");
  }
  DomainSpace(const DomainSpace&) = delete;
  DomainSpace& operator=(const DomainSpace&) = delete;
  ~DomainSpace() override {
    for (ob::State* state : states_) ob::RealVectorStateSpace::freeState(state);
  }

  /// States live no longer than the space: LazyPRM of OMPL 1.5 clones some that it never frees.
  ob::State* allocState() const override {
    ob::State* state = ob::RealVectorStateSpace::allocState();
    const std::lock_guard<std::mutex> lock(mutex_);
    states_.insert(state);
    return state;
  }
  void freeState(ob::State* state) const override {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      states_.erase(state);
    }
    ob::RealVectorStateSpace::freeState(state);
  }

  Index rows() const { return static_cast<Index>(getDimension()); }
  bool flat() const { return flat_; }
  ClearLines& lines() const { return lines_; }

  void interpolate(const ob::State* from, const ob::State* to, double t, ob::State* state) const override {
    ob::RealVectorStateSpace::interpolate(from, to, t, state);
    if (t > 0 && t < 1) settle(state);
  }
  ob::StateSamplerPtr allocDefaultStateSampler() const override;
  void registerProjections() override {
    constexpr unsigned kFew = 2;
    if (getDimension() <= kFew)
      registerDefaultProjection(std::make_shared<Coordinates>(this));
    else
      ob::RealVectorStateSpace::registerProjections();
  }

  /// To the nearest point of the domain; false where there is none.
  bool settle(ob::State* state) const {
    if (flat_) return true;
    const std::optional<Eigen::VectorXd> foot = lines_.nearest(values(state, rows()));
    if (foot) values(state, rows()) = *foot;
    return foot.has_value();
  }

 private:
  bool flat_;
  ClearLines& lines_;
  mutable std::mutex mutex_;  ///< PRM looks for solutions in a thread of its own
  mutable std::unordered_set<ob::State*> states_;
};

class DomainSampler final : public ob::StateSampler {
 public:
  explicit DomainSampler(const DomainSpace* space) : ob::StateSampler(space), domain_(*space) {}

  void sampleUniform(ob::State* state) override {
    sample(state, [&](double low, double high, Index) { return rng_.uniformReal(low, high); });
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const Eigen::VectorXd at = values(near, domain_.rows());
    sample(state, [&](double low, double high, Index i) {
      return rng_.uniformReal(std::max(low, at[i] - distance), std::min(high, at[i] + distance));
    });
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    const Eigen::VectorXd at = values(mean, domain_.rows());
    sample(state,
           [&](double low, double high, Index i) { return std::clamp(rng_.gaussian(at[i], deviation), low, high); });
  }

 private:
  template <class Draw>
  void sample(ob::State* state, const Draw& draw) {
    const ob::RealVectorBounds& bounds = domain_.getBounds();
    for (int k = 0; k < kTries; ++k) {  // what no try brings to a point is not valid
      for (Index i = 0; i < domain_.rows(); ++i) {
        const auto j = static_cast<std::size_t>(i);
        values(state, domain_.rows())[i] = draw(bounds.low[j], bounds.high[j], i);
      }
      if (domain_.settle(state) && domain_.satisfiesBounds(state)) return;
    }
  }

  const DomainSpace& domain_;
};

ob::StateSamplerPtr DomainSpace::allocDefaultStateSampler() const { return std::make_shared<DomainSampler>(this); }

/// An end is taken as it is, in contact too: it was looked at when it was placed.
class OnDomain final : public ob::StateValidityChecker {
 public:
  OnDomain(const ob::SpaceInformationPtr& information, const Problem& problem)
      : ob::StateValidityChecker(information),
        domain_(*information->getStateSpace()->as<DomainSpace>()),
        problem_(problem) {}

  bool isValid(const ob::State* state) const override {
    const Eigen::VectorXd x = values(state, domain_.rows());
    if (x == problem_.source.u || x == problem_.target.u) return true;
    if (!domain_.satisfiesBounds(state)) return false;
    if (!domain_.flat()) {
      const std::optional<Eigen::VectorXd> foot = domain_.lines().nearest(x);
      if (!foot || !((*foot - x).norm() <= kOnDomain * (1 + x.norm()))) return false;
    }
    return domain_.lines().is_clear(x, x);
  }

 private:
  const DomainSpace& domain_;
  const Problem& problem_;
};

class ClearMoves final : public ob::MotionValidator {
 public:
  explicit ClearMoves(const ob::SpaceInformationPtr& information)
      : ob::MotionValidator(information), domain_(*information->getStateSpace()->as<DomainSpace>()) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const bool clear = si_->isValid(to) && is_clear(values(from, domain_.rows()), values(to, domain_.rows()));
    ++(clear ? valid_ : invalid_);
    return clear;
  }

  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    const Eigen::VectorXd start = values(from, domain_.rows());
    ob::State* part = si_->allocState();
    double t = 0;
    for (int k = kPartsOfMove - 1; k > 0 && t == 0; --k) {
      const double there = static_cast<double>(k) / kPartsOfMove;
      domain_.interpolate(from, to, there, part);
      if (si_->isValid(part) && is_clear(start, values(part, domain_.rows()))) t = there;
    }
    si_->freeState(part);
    last.second = t;
    if (last.first != nullptr) domain_.interpolate(from, to, t, last.first);
    return false;
  }

 private:
  bool is_clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return domain_.lines().is_clear(a, b); }

  const DomainSpace& domain_;
};

}  // namespace

std::shared_ptr<ob::SpaceInformation> make_domain_space(const Problem& problem, const SampleBox& box,
                                                        ClearLines& lines) {
  const bool flat = problem.manifold->dimensions().tangent == problem.manifold->dimensions().ambient;
  const auto information = std::make_shared<ob::SpaceInformation>(std::make_shared<DomainSpace>(box, flat, lines));
  information->setStateValidityChecker(std::make_shared<OnDomain>(information, problem));
  information->setMotionValidator(std::make_shared<ClearMoves>(information));
  information->setStateValidityCheckingResolution(kResolution);
  information->setup();
  return information;
}

}  // namespace leastcost
