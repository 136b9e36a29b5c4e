// The layout of cdctl's help.
#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
} // namespace CLI

namespace cd {

/// Makes a formatter of help with the examples first. In an app's description, the first line says
/// what the verb does, and the others are its examples.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_help_formatter();

} // namespace cd
