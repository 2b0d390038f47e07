// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/layers/layer_stack.hpp>

namespace leastcost {

/// The layers that a path passes, in order; neighbours in it are neighbours in the stack. A path that runs along an
/// interface passes the faster layer beside it: (slow, fast, slow) with the middle leg on the interface is a head wave.
using LayerWord = std::vector<int>;

/// The interface between two neighbours.
inline int interface_between(int layer, int next) { return layer < next ? layer : next; }

/// Whether some least-cost path may have this word. No layer is passed twice without one of a lower index between: a
/// layer is convex, so that the straight leg within it would cost no more.
bool is_sensible(const LayerStack& stack, const LayerWord& word);
/// The same of a sensible word with one more layer at its end.
bool may_go_on(const LayerStack& stack, const LayerWord& word, int next);
/// The sensible word that is left when every loop which is not worth it is cut short.
LayerWord shortened(const LayerStack& stack, const LayerWord& word);
/// The word of a polyline, shortened; null where it leaves the layers.
std::optional<LayerWord> word_of_polyline(const LayerStack& stack, const Points& polyline);

std::string text(const LayerWord& word);  ///< "1 0 1"

}  // namespace leastcost
