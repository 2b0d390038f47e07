// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/tensor_reader.hpp"

#include <sstream>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/symmetric_eigen.hpp"
#include "problems/readers/file_content.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

constexpr double kSmallest = 1e-12;  ///< of the largest eigenvalue: below it a tensor is singular to rounding

void check(const Eigen::Matrix3d& tensor, const TextScanner& scanner) {
  const Eigen::VectorXd values = symmetric_eigenvalues(tensor);
  if (values[0] > kSmallest * values[2]) return;
  std::ostringstream message;
  message << "a tensor must be positive definite, but the eigenvalues of this one are " << values[0] << ", "
          << values[1] << ", " << values[2];
  if (values[0] >= -kSmallest * values[2] && values[1] > 0)
    message << " (to make a tensor of the tangent plane positive definite, add n n' with the unit normal n)";
  scanner.fail(message.str());
}

}  // namespace

std::vector<Eigen::Matrix3d> read_tensors(const std::filesystem::path& file) {
  const std::string content = read_content(file);
  TextScanner scanner(content, file.string(), {});
  std::vector<Eigen::Matrix3d> tensors;
  while (scanner.next_line()) {
    Eigen::Matrix3d t;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        t(i, j) = t(j, i) = scanner.number("one of the six entries xx xy xz yy yz zz of a tensor");
    scanner.expect_line_end("the six entries of a tensor");
    check(t, scanner);
    tensors.push_back(t);
  }
  if (tensors.empty()) throw InputError(file.string() + ": has no tensors");
  return tensors;
}

}  // namespace leastcost
