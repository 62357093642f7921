#pragma once

#include "core/journal/journal_record.h"

#include "core/util/job_control.h"

#include <filesystem>
#include <limits>

namespace core
{
/// A document out of its journal.
struct RecoveredDocument
{
    JournalDocument document;
    JournalHistory history;
    /// Of each step: what takes it back, or does it again, by Mesh::swap. Null where the journal does not reach: only
    /// those from the present to the first null on either side can be gone to.
    std::vector<std::shared_ptr<MeshDelta>> deltas;
    std::unique_ptr<Mesh> mesh;            ///< null if only the words were asked for
    std::shared_ptr<const Snapshot> start; ///< null if only the words were asked for
    std::uint64_t nextRecord = 0;          ///< its number
    unsigned nextSegment = 0;
    /// More was recorded than can be read any more. Where that is the start itself, `start` is what the newest base
    /// has.
    bool isDamaged = false;

    /// It has changes that no file holds.
    bool isUnsaved() const { return document.changedBeyondHistory || history.saved != history.present; }
};

struct RecoveryOptions
{
    /// Else only the words are read, from records whose checksums are right.
    bool mesh = true;
    unsigned endSegment = std::numeric_limits<unsigned>::max(); ///< those from it on are left alone
    std::stop_token stop = {};
};

/// Applies what a journal's folder holds, up to the first record that is not as it was written: damage costs what
/// follows it, and never gives a state that was not. Never runs the engine. Nothing if neither the start nor a base is
/// whole, or it was stopped. Reads only. Cost: reading, and swapping each record's elements. May throw std::bad_alloc.
std::optional<RecoveredDocument> recoverJournal(const std::filesystem::path& folder,
                                                const RecoveryOptions& options = {});
} // namespace core
