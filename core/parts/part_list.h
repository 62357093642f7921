#pragma once

#include "core/geometry/triangle_mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace core
{
/// Properties of a part. A part is a solid of its own: each vertex of the document's mesh belongs to one part, the
/// surface of each part bounds a solid, and the solids of different parts may overlap.
struct Part
{
    PartId id = 0;
    std::string name; ///< UTF-8; empty: the part has no name yet
    bool isVisible = true;
    bool isLocked = false;  ///< strokes and commands leave the part unchanged
    std::optional<Rgb> tag; ///< colour that marks the part in lists
    /// Turn from the document's axes to the part's own; they turn with the part. Unit length.
    Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();

    friend bool operator==(const Part&, const Part&) = default;
};

/// The parts of a document in the order in which lists show them. Ids are distinct. A document always has a part; a new
/// list has one, with id 0. Copies share their memory. Thread: any, as for values.
class PartList
{
public:
    static constexpr std::size_t maxParts = 1000;
    static constexpr std::size_t maxNameBytes = 200; ///< longest name, in bytes of UTF-8

    PartList() = default;
    /// Precondition: isUsable(parts).
    explicit PartList(std::vector<Part> parts);
    /// Returns whether the parts can be a list: at least one, at most maxParts, with distinct ids and names of at most
    /// maxNameBytes.
    static bool isUsable(const std::vector<Part>& parts);

    const std::vector<Part>& all() const;
    std::size_t size() const { return all().size(); }
    /// Returns the part with this id; null if there is none.
    const Part* find(PartId id) const;
    bool isVisible(PartId id) const;
    /// Returns whether the part exists, is visible and is not locked, so that it can be changed.
    bool isEditable(PartId id) const;
    /// Returns the smallest id that no part has.
    PartId freeId() const;
    /// Returns the name, shortened, or the name with the smallest number from 2 that makes it differ from all names in
    /// the list ("Ball 2"). An empty name stays empty.
    std::string freeName(const std::string& name) const;

    /// Returns the list with this part, which replaces a part with the same id or else becomes the last one.
    PartList with(Part part) const;
    /// Returns the list without the parts with these ids. Precondition: at least one part remains.
    PartList without(const std::vector<PartId>& ids) const;

    friend bool operator==(const PartList& a, const PartList& b)
    {
        return a.m_parts == b.m_parts || a.all() == b.all();
    }

private:
    std::shared_ptr<const std::vector<Part>> m_parts; ///< null: the list of a new document
};

/// Returns the name cut to at most `maxBytes` bytes, at the end of a character.
std::string shortened(std::string name, std::size_t maxBytes = PartList::maxNameBytes);
} // namespace core
