#pragma once

#include "core/io/document_metadata.h"
#include "core/io/stroke/stroke_file.h"
#include "core/mesh/mesh_delta.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace core
{
/// What a history shows of a step, and what did it. Texts are UTF-8.
struct JournalStep
{
    std::string text, icon;
    std::uint64_t dabs = 0, fusions = 0;
    /// As a stroke file would have it: what is in files of its own is not there; null: not known.
    std::shared_ptr<const FileEntry> entry = {};

    /// By what would be written of them.
    friend bool operator==(const JournalStep& a, const JournalStep& b);
};

/// What belongs to the document beside its mesh.
struct JournalDocument
{
    std::string name, path;            ///< UTF-8; no path: it comes from no file
    DocumentMetadata metadata;         ///< without the frame, which is the mesh's
    bool changedBeyondHistory = false; ///< it is unsaved, whatever the history says
};

/// The steps, done and undone.
struct JournalHistory
{
    std::vector<JournalStep> steps;
    std::uint32_t present = 0; ///< so many are done
    /// So many were when the file was written; none: it is not a state of these steps.
    std::optional<std::uint32_t> saved = 0;
    bool isWhole = true; ///< the first was done to the model as it was opened
    friend bool operator==(const JournalHistory&, const JournalHistory&) = default;
};

// --- the kinds of records

/// The model as it was opened.
struct StartRecord
{
    std::shared_ptr<const Snapshot> start;
    JournalDocument document;
};
/// A step was done, in place of those that were undone: its elements as they are now.
struct ChangeRecord
{
    std::uint32_t index = 0; ///< of the step
    JournalStep step;
    MeshDelta image;
};
/// A step was undone or done again: its elements as they are now.
struct SwapRecord
{
    std::uint32_t index = 0;
    bool isDone = false; ///< again; else undone
    MeshDelta image;
};
/// The file holds what the model was when so many steps were done.
struct SavedRecord
{
    std::uint32_t index = 0;
};
/// The steps cannot be undone any more.
struct ForgottenRecord
{};
/// A part of a mesh, some slots of each kind: all parts together are the mesh.
struct PartRecord
{
    MeshDelta image;
};
/// Closes a mesh in parts: the document at that moment.
struct BaseRecord
{
    JournalDocument document;
    JournalHistory history;
};

using JournalRecord = std::variant<StartRecord, ChangeRecord, SwapRecord, SavedRecord, JournalDocument, ForgottenRecord,
                                   PartRecord, BaseRecord>;

/// A record as it stands in a file: mark, kind, number, length, content, checksum of all these.
std::string pack(const JournalRecord& record, std::uint64_t number);

struct NumberedRecord
{
    std::uint64_t number = 0;
    JournalRecord record;
};
/// The first record of these bytes, which are cut by it; nothing if it is not whole.
std::optional<NumberedRecord> unpack(std::string_view& bytes);
/// Whether there is a whole record anywhere in them.
bool holdsRecord(std::string_view bytes);
} // namespace core
