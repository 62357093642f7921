#include "core/journal/compaction.h"

#include "core/journal/journal_base.h"
#include "core/journal/journal_files.h"
#include "core/journal/journal_recovery.h"
#include "core/mesh/mesh.h"

#include "core/util/file_error.h"

#include <new>

namespace core
{
bool compactJournal(const std::filesystem::path& folder, unsigned segment, const std::stop_token& stop)
{
    try {
        const auto document = recoverJournal(folder, {.endSegment = segment, .stop = stop});
        const std::string bytes = contentOf(segmentFile(folder, segment));
        std::string_view rest = bytes;
        const auto next = unpack(rest);
        if (!document || !next || next->number != document->nextRecord || stop.stop_requested())
            return false;
        writeBase(baseFile(folder, segment), *document->mesh, {document->document, document->history},
                  document->nextRecord - 1);
    } catch (const FileError&) {
        return false;
    } catch (const std::bad_alloc&) {
        return false;
    }
    const JournalFiles files = filesIn(folder);
    std::error_code ignored; // files that cannot be removed do no harm: recovery begins at the newest base
    for (const auto& base : files.bases)
        if (base.first < segment)
            std::filesystem::remove(baseFile(folder, base.first), ignored);
    for (const auto& old : files.segments)
        if (old.first < segment)
            std::filesystem::remove(segmentFile(folder, old.first), ignored);
    return true;
}
} // namespace core
