// The extensions of glTF files: which are known, and which make a file unreadable.
#pragma once

#include "client/import/gltf_fields.hpp"

namespace cd {

/// Reports the first name in `extensionsRequired` that is not known: who does not know it must not
/// read the file (glTF 2.0, section 3.12). `file` is the whole document.
void refuse_unknown_extensions(const GltfFields& file);

/// Reports an object whose numbers an extension compresses.
void refuse_compression(const GltfFields& object);

} // namespace cd
