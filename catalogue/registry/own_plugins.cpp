// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The lists of plug-ins with what a program has registered, and the registration.
#include <leastcost/catalogue/registry/register.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <mutex>
#include <string_view>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/plugins/check_dimension.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/plugins/plugin.hpp"
#include "catalogue/plugins/run_visitor.hpp"
#include "catalogue/registry/registry.hpp"

namespace leastcost {
namespace {

/// Options of a registration among those of the library.
class RegisteredOptions final : public AnyOptions {
 public:
  explicit RegisteredOptions(std::unique_ptr<OwnOptions> own) : own_(std::move(own)) {}
  void fields(RunVisitor& visit) override { own_->fields(visit); }
  const OwnOptions& own() const { return *own_; }

 private:
  std::unique_ptr<OwnOptions> own_;
};

constexpr const char* kOwn = "registered by the program";

bool is_word(std::string_view text) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !text.empty() && letter(text.front()) &&
         std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

/// Words that YAML, or older readers of it, take for a value: `type: true` is no name.
bool is_yaml_value(std::string_view text) {
  constexpr std::array<std::string_view, 7> kValues = {"true", "false", "null", "yes", "no", "on", "off"};
  return std::find(kValues.begin(), kValues.end(), text) != kValues.end();
}

/// The lists as they are now. Readers hold references to them without a lock: a registration makes new ones, and those
/// of before stay where they are.
class Lists {
 public:
  static Lists& all() {
    static Lists lists;
    return lists;
  }

  const std::vector<PluginKind>& now() const { return *now_.load(std::memory_order_acquire); }

  /// `replaces`: the place of one of this name that is not the library's.
  void add(std::string_view kind_name, std::shared_ptr<const PluginEntry> entry, bool replaces) {
    const std::lock_guard lock(mutex_);
    std::vector<PluginKind> kinds = now();
    PluginKind& kind = *std::find_if(kinds.begin(), kinds.end(), [&](auto& k) { return k.name == kind_name; });
    const auto same = std::find_if(kind.entries.begin(), kind.entries.end(),
                                   [&](const PluginEntry* known) { return known->type == entry->type; });
    if (same != kind.entries.end() && !(replaces && (*same)->library == kOwn))
      throw InputError(
          fmt::format("cannot register the {0} '{1}': there is {2} {0} of this name already; give it another "
                      "one",
                      kind.name, entry->type, kind.name.front() == 'o' || kind.name.front() == 'i' ? "an" : "a"));
    if (same != kind.entries.end())
      *same = entry.get();
    else
      kind.entries.push_back(entry.get());
    own_.push_back(std::move(entry));
    now_.store(&lists_.emplace_back(std::move(kinds)), std::memory_order_release);
  }

 private:
  Lists() : now_(&lists_.emplace_back(built_in_kinds())) {}

  std::mutex mutex_;
  std::deque<std::vector<PluginKind>> lists_;  // the last one is that of now
  std::vector<std::shared_ptr<const PluginEntry>> own_;
  std::atomic<const std::vector<PluginKind>*> now_;
};

/// The plug-in of another space, or none at all, is found out where it is made.
template <class Made>
void check_made(const Made& made, const std::string& type, const BuildContext& context) {
  if constexpr (requires { made == nullptr; }) {
    if (made == nullptr) throw InputError(fmt::format("the factory of '{}' returned a null pointer", type));
  }
  if constexpr (std::is_same_v<Made, std::shared_ptr<const SegmentCost>>) check_dimension(*made, context, "type");
}

template <class Made>
void add(const char* kind, OwnPlugin<Made> own) {
  const auto refuse = [&](const char* why) {
    throw InputError(fmt::format("cannot register the {} '{}': {}", kind, own.type, why));
  };
  if (!is_word(own.type)) refuse("a name has lower-case letters, digits and _, and begins with a letter");
  if (is_yaml_value(own.type)) refuse("YAML takes this word for a value, not for a name; give it another one");
  if (own.type == kExternal) refuse("this name stands for the objects that a program hands over");
  if (own.summary.empty()) refuse("give a sentence that says what it is");
  auto entry = std::make_shared<Plugin<Made>>();
  entry->type = std::move(own.type);
  entry->summary = std::move(own.summary);
  entry->provides = std::move(own.provides);
  entry->needs = std::move(own.facts.needs);
  entry->library = kOwn;
  entry->follows_source = own.facts.follows_source;
  entry->ambient = own.facts.ambient;
  entry->defaults = [defaults = std::move(own.defaults)] { return std::make_unique<RegisteredOptions>(defaults()); };
  entry->waits_for = [what = own.facts.waits_for](const AnyOptions&) { return what; };
  entry->make = [make = std::move(own.make), type = entry->type](const AnyOptions& o, const BuildContext& context) {
    Made made = make(static_cast<const RegisteredOptions&>(o).own(), context);
    check_made(made, type, context);
    return made;
  };
  Lists::all().add(kind, std::move(entry), own.replaces);
}

}  // namespace

const std::vector<PluginKind>& plugin_kinds() { return Lists::all().now(); }

void add_plugin(OwnPlugin<std::shared_ptr<const ConstraintManifold>> plugin) { add("manifold", std::move(plugin)); }
void add_plugin(OwnPlugin<std::shared_ptr<const SegmentCost>> plugin) { add("cost", std::move(plugin)); }
void add_plugin(OwnPlugin<std::shared_ptr<const Kernel>> plugin) { add("kernel", std::move(plugin)); }
void add_plugin(OwnPlugin<std::shared_ptr<const Initializer>> plugin) { add("initializer", std::move(plugin)); }
void add_plugin(OwnPlugin<std::shared_ptr<const Solver>> plugin) { add("solver", std::move(plugin)); }
void add_plugin(OwnPlugin<std::shared_ptr<const PostProcessor>> plugin) { add("post_processor", std::move(plugin)); }
void add_plugin(OwnPlugin<std::vector<std::shared_ptr<const Obstacle>>> plugin) { add("obstacle", std::move(plugin)); }

}  // namespace leastcost
