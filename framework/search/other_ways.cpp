// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/other_ways.hpp"

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/result/other_images.hpp>

namespace leastcost {

void note_cheaper_image(const Search& search, Outcome& out) {
  Monitor quiet = search.monitor;
  quiet.observe = nullptr;
  try {
    std::string note = cheaper_image(out.solved, out.result.curve.cost, quiet);
    if (!note.empty()) out.result.notes.push_back(std::move(note));
  } catch (const Interrupted&) {  // the certificate stands
  }
}

void note_free_ways(const Search&, Outcome& out) {
  const std::optional<Regularization>& found = out.result.certificate.regularization;
  if (!found || found->free_ways.empty()) return;
  out.result.notes.push_back(found->free_ways + (out.result.certificate.certified()
                                                     ? ": the value is certified, but the path is not unique"
                                                     : ": the path is not unique"));
}

}  // namespace leastcost
