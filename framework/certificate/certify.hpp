// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/certificate/to_curve.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Measures the delivered path: `path.chain` is what the caller gets, `path.curve` lies on the domain. The refinement
/// levels are solved by Newton on the chain, whatever made the path. Stopped, or after the deadline, it has the failure
/// `interrupted` and no error bar.
Certificate certify(const Problem& problem, double reference_cost, const PostProcessed& path, const ToCurve& to_curve,
                    const CertificateOptions& options, const Monitor& monitor);

}  // namespace leastcost
