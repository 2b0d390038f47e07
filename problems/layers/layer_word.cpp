// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/layers/layer_word.hpp"

#include <algorithm>

namespace leastcost {
namespace {

/// Appends the layers from the last one of the word (not included) to `layer`.
void go_to(int layer, LayerWord& word) {
  while (word.back() != layer) word.push_back(word.back() + (layer > word.back() ? 1 : -1));
}

/// That of the layers which touch a point to which the way is shortest.
int nearest_of(const std::vector<int>& layers, int to) {
  return *std::min_element(layers.begin(), layers.end(),
                           [&](int a, int b) { return std::abs(a - to) < std::abs(b - to); });
}

}  // namespace

bool may_go_on(const LayerStack& stack, const LayerWord& word, int next) {
  for (std::size_t i = word.size(); i-- > 0;) {
    if (word[i] == next) return false;
    if (stack.index(word[i]) < stack.index(next)) return true;
  }
  return true;
}

bool is_sensible(const LayerStack& stack, const LayerWord& word) {
  LayerWord part;
  for (const int layer : word) {
    if (!may_go_on(stack, part, layer)) return false;
    part.push_back(layer);
  }
  return true;
}

LayerWord shortened(const LayerStack& stack, const LayerWord& word) {
  LayerWord out;
  for (const int layer : word) {
    if (may_go_on(stack, out, layer))
      out.push_back(layer);
    else
      while (out.back() != layer) out.pop_back();
  }
  return out;
}

std::optional<LayerWord> word_of_polyline(const LayerStack& stack, const Points& polyline) {
  LayerWord word;
  for (Index i = 0; i + 1 < polyline.cols(); ++i) {
    const std::vector<int> from = stack.layers_at(polyline.col(i)), to = stack.layers_at(polyline.col(i + 1));
    if (from.empty() || to.empty()) return std::nullopt;
    if (const auto within = stack.layer_of_leg(polyline.col(i), polyline.col(i + 1))) {
      if (word.empty()) word.push_back(*within);
      go_to(*within, word);
      continue;
    }
    if (word.empty()) word.push_back(nearest_of(from, to.front()));
    go_to(nearest_of(from, to.front()), word);
    go_to(nearest_of(to, word.back()), word);
  }
  return shortened(stack, word);
}

std::string text(const LayerWord& word) {
  std::string out;
  for (const int layer : word) out += (out.empty() ? "" : " ") + std::to_string(layer);
  return out;
}

}  // namespace leastcost
