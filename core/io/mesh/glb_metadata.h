#pragma once

#include "core/io/document_metadata.h"

#include <nlohmann/json.hpp>

#include <istream>

namespace core::io
{
/// Adds the metadata to a glTF document as the extension FETTLE_document, which readers may ignore:
///
///     {"version": 1, "unit": "mm", "lattice": 16, "uniformDetail": 1.5, "palette": ["c86e50", "8a5a3c"],
///      "view": {"target": [0, 0, 0], "distance": 300, "yaw": 0.5, "pitch": 0.35, "orthographic": false},
///      "brush": {...}, "work": {"strokes": 120, "seconds": 845.5},
///      "references": [{"side": "front", "path": "lion.jpg", "width": 120, "x": 0, "y": 50, "opacity": 0.6,
///                      "inFront": false}],
///      "parts": [{"id": 0, "name": "Body", "visible": true, "locked": false, "tag": "ff0000"}]}
///
/// Empty metadata and a list of parts like that of a new document add no extension. "parts" is in the order of the
/// nodes; a part without a tag has no "tag". Coordinates are multiples of 2^-lattice mm. "brush" is a stroke of a
/// stroke file without samples. A model that is not at its file's origin also has "place": [x, y, z], mm
/// (MeshFrame::place).
void addMetadata(nlohmann::ordered_json& document, const DocumentMetadata& metadata, const PartList& parts);

/// Reads the metadata from the start of a GLB. Ignores entries that addMetadata() would not have written.
DocumentMetadata readGlbMetadata(std::istream& file);

/// Returns the parts that addMetadata() added to a glTF document; nothing if there are none, if addMetadata() would not
/// have written them, or if the document has more or fewer nodes.
std::optional<PartList> partsIn(const nlohmann::json& document);
} // namespace core::io
