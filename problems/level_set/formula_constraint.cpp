// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/level_set/formula_constraint.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace leastcost {
namespace {

/// Gradients by dual numbers of width W: in one sweep for n = W, else in sweeps of W coordinates each.
template <int W>
class FormulaConstraint final : public ConstraintFunction, private LevelSetEnclosure {
 public:
  explicit FormulaConstraint(Formulas formulas) : formulas_(std::move(formulas)) {}
  int inputs() const override { return formulas_.inputs(); }
  int outputs() const override { return formulas_.outputs(); }

  void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                Eigen::Ref<Points> gradients) const override {
    using S = Dual<double, W>;
    const auto n = static_cast<std::size_t>(inputs()), k = static_cast<std::size_t>(outputs());
    std::array<S, kMaxDimension> at, f;
    for (std::size_t i = 0; i < n; ++i) at[i] = S(x[static_cast<Index>(i)]);
    for (std::size_t begin = 0; begin < n; begin += W) {
      const std::size_t count = std::min<std::size_t>(W, n - begin);
      for (std::size_t c = 0; c < count; ++c) at[begin + c].d[c] = 1;
      formulas_.evaluate<S>(std::span<const S>(at.data(), n), std::span<S>(f.data(), k));
      for (std::size_t j = 0; j < k; ++j) {
        value[static_cast<Index>(j)] = f[j].value;
        for (std::size_t c = 0; c < count; ++c)
          gradients(static_cast<Index>(begin + c), static_cast<Index>(j)) = f[j].d[c];
      }
      for (std::size_t c = 0; c < count; ++c) at[begin + c].d[c] = 0;
    }
  }

  bool knows_curvature() const override { return inputs() == W; }
  void curvature(const Eigen::Ref<const Eigen::VectorXd>& x, const Eigen::Ref<const Eigen::VectorXd>& weights,
                 Eigen::Ref<Points> out) const override {
    using S = SecondDual<W>;
    const Point<S, W> at = seeded_twice<W>(x);
    std::array<S, W> f;  // fewer equations than coordinates
    const std::span<S> values(f.data(), static_cast<std::size_t>(outputs()));
    formulas_.evaluate<S>(std::span<const S>(at.data(), W), values);
    sum_of_curvatures<W>(values, weights, out);
  }

  const LevelSetEnclosure* enclosure() const override { return inputs() == 3 && outputs() == 1 ? this : nullptr; }

 private:
  IntervalJet<3> enclose(std::span<const IntervalJet<3>, 3> x) const override { return value_at(x); }
  Sloped enclose(std::span<const Sloped, 3> x) const override { return value_at(x); }

  template <class S>
  S value_at(std::span<const S, 3> x) const {
    S f;
    formulas_.evaluate<S>(x, std::span<S>(&f, 1));
    return f;
  }

  Formulas formulas_;
};

}  // namespace

std::shared_ptr<const ConstraintFunction> make_formula_constraint(Formulas formulas) {
  switch (formulas.inputs()) {
    case 1:
    case 2: return std::make_shared<FormulaConstraint<2>>(std::move(formulas));
    case 3: return std::make_shared<FormulaConstraint<3>>(std::move(formulas));
    default: return std::make_shared<FormulaConstraint<4>>(std::move(formulas));
  }
}

}  // namespace leastcost
