// Checks that every instance in a COLLADA scene refers to a rigid mesh of the file.
#pragma once

#include "client/import/foreign/xml_text.hpp"

namespace cd {

/// Checks all instances. Errors: BadInput naming the line, for an instance of a skin or a morph, of
/// a geometry without a mesh, or of something outside the file.
[[nodiscard]] Status check_collada_instances(const XmlText& xml);

} // namespace cd
