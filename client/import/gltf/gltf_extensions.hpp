// Refuses glTF files that depend on unsupported extensions.
#pragma once

#include "client/import/gltf/gltf_fields.hpp"

namespace cd {

/// Reports the first unknown name in `extensionsRequired`: a reader that does not know a required
/// extension must refuse the file (glTF 2.0, section 3.12). `file` is the whole document.
void refuse_unknown_extensions(const GltfFields& file);

/// Reports an object whose geometry is compressed by an extension.
void refuse_compression(const GltfFields& object);

} // namespace cd
