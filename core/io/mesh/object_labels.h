#pragma once

#include "core/io/mesh/format.h"

#include <string>
#include <vector>

namespace core::io
{
/// Returns the name as valid UTF-8 without control characters and blanks at its ends, shortened() to what a part can
/// have. Bytes that are not UTF-8 become question marks.
std::string cleanName(std::string_view name);

/// Counts a part that a slicer does not print as left out. Keeps its name, cleaned and cut to 40 bytes, if it has one
/// that differs from the names kept so far, and these are fewer than three.
void leaveOutPart(ReadRemarks& remarks, bool isNegative, std::string_view name);

/// Labels the points of a mesh by the objects of a file while a reader appends them.
class ObjectLabels
{
public:
    explicit ObjectLabels(bool isOn) : m_isOn(isOn) {}

    bool isOn() const { return m_isOn; }
    /// Begins the next object. `name`: as in the file.
    void begin(std::string_view name);
    /// Gives the points that have no label yet to the present object. Precondition: there is one.
    void label(TriangleMesh& mesh) const;
    std::size_t objects() const { return m_names.size(); }

    /// Makes parts of the objects that have faces. Returns their names, with ids from 0 on. If there are fewer than two
    /// or more than PartList::maxParts, the mesh gets no labels. Precondition: all points are labelled.
    PartList finish(TriangleMesh& mesh) const;
    /// Makes the objects parts with the ids of this list, in its order. Returns false and does nothing if there are
    /// more or fewer objects.
    bool finishAs(const PartList& parts, TriangleMesh& mesh) const;

private:
    bool m_isOn;
    std::vector<std::string> m_names;
};
} // namespace core::io
