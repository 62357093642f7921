#pragma once

#include "core/journal/journal_record.h"

#include "core/util/job_control.h"

#include <filesystem>
#include <limits>

namespace core
{
/// A document read from its journal.
struct RecoveredDocument
{
    JournalDocument document;
    JournalHistory history;
    /// One delta per step, which undoes or redoes the step by Mesh::swap. Null where the journal has no delta: undo and
    /// redo can go only as far as the first null on each side of the present.
    std::vector<std::shared_ptr<MeshDelta>> deltas;
    std::unique_ptr<Mesh> mesh; ///< null if RecoveryOptions::mesh is false
    /// The model as it was opened (but see isDamaged); null if neither the start nor the mesh was read.
    std::shared_ptr<const Snapshot> start;
    std::uint64_t nextRecord = 0; ///< number of the next record to be written
    unsigned nextSegment = 0;
    /// Some records could not be read. If the start record itself is lost, `start` is the mesh of the newest base.
    bool isDamaged = false;

    /// Returns whether the document has changes that are not saved in its file.
    bool isUnsaved() const { return document.changedBeyondHistory || history.saved != history.present; }
};

struct RecoveryOptions
{
    /// false: reads only texts and metadata, and trusts every record whose checksum is right
    bool mesh = true;
    unsigned endSegment = std::numeric_limits<unsigned>::max(); ///< segments from this number on are ignored
    std::stop_token stop = {};
};

/// Reads a journal's folder and applies its records up to the first damaged one. Records after damage are lost, but the
/// result is always a state that the document really had. Applies recorded elements and never runs the engine. Never
/// writes. Returns nothing if neither the start nor a base is complete, or if it was stopped. May throw std::bad_alloc.
/// Cost: reading, and swapping each record's elements.
std::optional<RecoveredDocument> recoverJournal(const std::filesystem::path& folder,
                                                const RecoveryOptions& options = {});
} // namespace core
