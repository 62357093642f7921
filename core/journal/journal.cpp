#include "core/journal/journal.h"

#include "core/journal/delta_images.h"
#include "core/journal/journal_base.h"
#include "core/journal/journal_files.h"

#include "core/util/atomic_file.h"

#include <new>

namespace core
{
Journal::Journal(std::shared_ptr<JournalFolder> folder, JournalWriter::Place place, JournalCallbacks callbacks,
                 JournalLimits limits, std::uint32_t present)
    : m_folder(std::move(folder))
    , m_present(present)
    , m_writer(std::make_unique<JournalWriter>(m_folder->path(), place, std::move(callbacks), limits))
{}

std::shared_ptr<Journal> Journal::begin(const std::filesystem::path& root, const StartRecord& start,
                                        JournalCallbacks callbacks, JournalLimits limits)
{
    auto folder = JournalFolder::make(root);
    try {
        writeStart(folder->path(), start);
    } catch (const FileError&) {
        folder->remove();
        throw;
    }
    return std::shared_ptr<Journal>(new Journal(std::move(folder), {}, std::move(callbacks), limits, 0));
}

std::shared_ptr<Journal> Journal::resume(std::unique_ptr<JournalFolder> folder, const RecoveredDocument& document,
                                         JournalCallbacks callbacks, JournalLimits limits)
{
    const JournalWriter::Place place{document.nextRecord, document.nextSegment};
    return std::shared_ptr<Journal>(
        new Journal(std::move(folder), place, std::move(callbacks), limits, document.history.present));
}

std::shared_ptr<Journal> Journal::beginDeferred(std::shared_ptr<JournalFolder> folder, std::uint32_t present,
                                                JournalCallbacks callbacks, JournalLimits limits)
{
    return std::shared_ptr<Journal>(
        new Journal(std::move(folder), {.waits = true}, std::move(callbacks), limits, present));
}

void Journal::beginWith(std::shared_ptr<const Mesh> mesh, StartRecord start, BaseRecord base)
{
    m_writer->begin([this, mesh = std::move(mesh), start = std::move(start), base = std::move(base)] {
        if (!mesh)
            throw std::bad_alloc();
        const std::filesystem::path folder = m_folder->hiddenPath();
        writeStart(folder, start);
        syncFile(startFile(folder));
        writeBase(baseFile(folder, 0), *mesh, base, 0);
        m_folder->show();
        syncFolder(m_folder->path().parent_path());
    });
}

void Journal::changed(const Mesh& mesh, const MeshDelta& delta, JournalStep step)
{
    m_writer->add(ChangeRecord{m_present++, std::move(step), imageOf(mesh, delta)});
}

void Journal::swapped(const Mesh& mesh, const MeshDelta& delta, std::uint32_t index)
{
    const bool isDone = index >= m_present;
    m_present = isDone ? index + 1 : index;
    m_writer->add(SwapRecord{index, isDone, imageOf(mesh, delta)});
}

void Journal::forget()
{
    m_present = 0;
    m_writer->add(ForgottenRecord{});
}

void Journal::remove()
{
    m_writer.reset();
    m_folder->remove();
}
} // namespace core
