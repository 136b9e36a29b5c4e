// Whether all that a COLLADA scene is made of is there, and is rigid.
#pragma once

#include "client/import/xml_text.hpp"

namespace cd {

/// Errors: BadInput naming the line, for an instance of what is not in the file, of a geometry that
/// is no mesh, and of a skin or a morph.
[[nodiscard]] Status check_collada_instances(const XmlText& xml);

} // namespace cd
