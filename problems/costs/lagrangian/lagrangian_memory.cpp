// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/lagrangian/lagrangian_memory.hpp"

#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

constexpr std::size_t kAnswersKept = 64;  ///< answers

struct LagrangianAnswer {
  LagrangianQuestion question;
  LagrangianCheck check;
  std::optional<OptionError> refusal;
};

class LagrangianMemory {
 public:
  std::optional<LagrangianAnswer> find(const LagrangianQuestion& question) {
    const std::lock_guard<std::mutex> guard(lock_);
    for (const LagrangianAnswer& known : answers_)
      if (known.question == question) return known;
    return std::nullopt;
  }
  void keep(LagrangianAnswer answer) {
    const std::lock_guard<std::mutex> guard(lock_);
    if (answers_.size() == kAnswersKept) answers_.pop_front();
    answers_.push_back(std::move(answer));
  }

 private:
  std::mutex lock_;
  std::deque<LagrangianAnswer> answers_;
};

bool same(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == b.size() && a == b; }

}  // namespace

bool LagrangianQuestion::operator==(const LagrangianQuestion& other) const {
  return text == other.text && parameters == other.parameters && dim == other.dim && any_shape == other.any_shape &&
         same(box.lower, other.box.lower) && same(box.upper, other.box.upper);
}

LagrangianCheck remembered_check(const LagrangianQuestion& question, const std::function<LagrangianCheck()>& check) {
  static LagrangianMemory memory;
  std::optional<LagrangianAnswer> answer = memory.find(question);
  if (!answer) {
    answer.emplace(LagrangianAnswer{question, {}, {}});
    try {
      answer->check = check();  // not under the lock: other threads go on
    } catch (const OptionError& error) {
      answer->refusal = error;
    }
    memory.keep(*answer);
  }
  if (answer->refusal) throw OptionError(*answer->refusal);
  return answer->check;
}

}  // namespace leastcost
