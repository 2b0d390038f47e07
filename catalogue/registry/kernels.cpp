// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/kernels/kernels.hpp>
#include "catalogue/plugins/registration.hpp"

namespace leastcost {
namespace {

template <class Function>
KernelPlugin kernel(const char* type, const char* summary) {
  return plugin<KernelPlugin, NoOptions>(type, summary,
                                         [](const NoOptions&, const BuildContext&) { return make_kernel(Function{}); });
}

}  // namespace

const std::vector<KernelPlugin>& built_in::kernels() {
  static const std::vector<KernelPlugin> all = {
      kernel<Linear>("linear",
                     "H(s) = s: the plain cost. Points can slide along the path, so nothing can be certified."),
      kernel<Square>("square", "H(s) = s^2: the usual path energy; enforces equal spacing less strongly."),
      kernel<Expm1Square>("expm1_square",
                          "H(s) = exp(s^2) - 1: the choice of VFCS, enforces equal spacing most strongly."),
      kernel<Exp>("exp", "H(s) = exp(s)."),
      kernel<Expm1>("expm1", "H(s) = exp(s) - 1."),
      kernel<ExpSquare>("exp_square", "H(s) = exp(s^2)."),
  };
  return all;
}

}  // namespace leastcost
