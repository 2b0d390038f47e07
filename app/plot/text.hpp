// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace leastcost::app {

/// Text as it may stand in an element or a quoted attribute of HTML and SVG. Control characters, and bytes that are not
/// UTF-8, become U+FFFD.
std::string escaped(std::string_view text);

/// A number for people: `digits` significant ones, "1.2 × 10⁻⁷" below 1e-3 and from 1e6 on; "∞", "n/a" for NaN.
std::string number_text(double value, int digits = 3);

/// "10⁻⁷".
std::string power_of_ten(int exponent);

/// Bytes in base 64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Width of a text in units of its font size, estimated: good to a tenth for Latin letters and digits.
double text_width(std::string_view text);

}  // namespace leastcost::app
