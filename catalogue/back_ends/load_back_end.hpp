// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace leastcost {

/// Makes a plug-in of a back end: `options` points to its options, `made` to the std::shared_ptr that takes it. Throws
/// what the constructor of the plug-in throws.
using BackEndMaker = void (*)(const void* options, int seed, void* made);

/// The maker in a shared module of a back end (leastcost_back_end_module() in cmake/leastcost_back_end.cmake), which is
/// loaded if it is not yet. `library`: for people; `file`: the name of the module, looked for where the program or the
/// Python package was linked to look for libraries. Throws InputError where the module, or a library that it stands on,
/// cannot be loaded.
BackEndMaker load_back_end(const char* library, const char* file);

/// A plug-in made by a module, as the entries of the registry want it.
template <class Class, class Options>
std::shared_ptr<const Class> made_by_module(const char* library, const char* file, const Options& options, int seed) {
  std::shared_ptr<const Class> made;
  load_back_end(library, file)(&options, seed, &made);
  return made;
}

}  // namespace leastcost
