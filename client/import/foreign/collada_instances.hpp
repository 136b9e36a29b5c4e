// Checks that every instance in a COLLADA scene refers to a rigid mesh of the file.
#pragma once

#include "client/import/foreign/xml_text.hpp"

namespace cd {

/// Errors: BadInput naming the line, for an instance that refers to something outside of the file,
/// to a geometry without a mesh, or to a skin or a morph.
[[nodiscard]] Status check_collada_instances(const XmlText& xml);

} // namespace cd
