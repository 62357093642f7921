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
/// The description of a step that a history shows, and the command that made the step. Texts are UTF-8.
struct JournalStep
{
    std::string text, icon;
    std::uint64_t dabs = 0, fusions = 0;
    /// The step's command in the stroke file's form, without the content of files that it references; null: not known.
    std::shared_ptr<const FileEntry> entry = {};

    /// Compares the bytes that would be written for the steps.
    friend bool operator==(const JournalStep& a, const JournalStep& b);
};

/// The data of a document in addition to its mesh.
struct JournalDocument
{
    std::string name, path;            ///< UTF-8; an empty path: the document has no file
    DocumentMetadata metadata;         ///< metadata without the frame, which is part of the mesh
    bool changedBeyondHistory = false; ///< true: the document is unsaved regardless of the history's state
};

/// All steps of a document, done and undone.
struct JournalHistory
{
    std::vector<JournalStep> steps;
    std::uint32_t present = 0; ///< number of steps that are done
    /// Number of steps that were done when the file was saved. Empty: the saved state is not among these steps.
    std::optional<std::uint32_t> saved = 0;
    bool isWhole = true; ///< true: the first step was done to the model as it was opened
    friend bool operator==(const JournalHistory&, const JournalHistory&) = default;
};

// --- the kinds of records, in the order of JournalRecord

/// The model as it was opened.
struct StartRecord
{
    std::shared_ptr<const Snapshot> start;
    JournalDocument document;
};
/// A new step, which replaces any undone steps. `image` has the changed elements after the step.
struct ChangeRecord
{
    std::uint32_t index = 0; ///< index of the step in the history
    JournalStep step;
    MeshDelta image;
};
/// A step that was undone or redone. `image` has the changed elements afterwards.
struct SwapRecord
{
    std::uint32_t index = 0;
    bool isDone = false; ///< true: redone; false: undone
    MeshDelta image;
};
/// The document was saved to its file when `index` steps were done.
struct SavedRecord
{
    std::uint32_t index = 0;
};
/// The history was cleared: no earlier step can be undone any more.
struct ForgottenRecord
{};
/// Part of a mesh: a range of slots of vertices, edges and faces. All parts together are the mesh.
struct PartRecord
{
    MeshDelta image;
};
/// The last record of a base: the document and its history when the base was made.
struct BaseRecord
{
    JournalDocument document;
    JournalHistory history;
};

using JournalRecord = std::variant<StartRecord, ChangeRecord, SwapRecord, SavedRecord, JournalDocument, ForgottenRecord,
                                   PartRecord, BaseRecord>;

/// Returns the bytes of a record in a file: mark, kind, number, length, content, and a checksum of all these.
std::string pack(const JournalRecord& record, std::uint64_t number);

struct NumberedRecord
{
    std::uint64_t number = 0;
    JournalRecord record;
};
/// Reads the first record and removes it from the bytes. Returns nothing, and leaves the bytes unchanged, if the record
/// is incomplete or damaged.
std::optional<NumberedRecord> unpack(std::string_view& bytes);
/// Returns whether the bytes contain a complete record at any position.
bool holdsRecord(std::string_view bytes);
} // namespace core
