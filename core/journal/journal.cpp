#include "journal.h"

#include "images.h"

namespace core
{
Journal::Journal(std::unique_ptr<JournalFolder> folder, JournalWriter::Place place, JournalWriter::Broken broken, JournalLimits limits,
                 std::uint32_t present)
    : m_folder(std::move(folder)), m_present(present),
      m_writer(std::make_unique<JournalWriter>(m_folder->path(), place, std::move(broken), limits))
{
}

std::shared_ptr<Journal> Journal::begin(const std::filesystem::path& root, const StartRecord& start, JournalWriter::Broken broken,
                                        JournalLimits limits)
{
    auto folder = JournalFolder::make(root);
    try {
        writeStart(folder->path(), start);
    } catch (const FileError&) {
        folder->remove();
        throw;
    }
    return std::shared_ptr<Journal>(new Journal(std::move(folder), {}, std::move(broken), limits, 0));
}

std::shared_ptr<Journal> Journal::goOn(std::unique_ptr<JournalFolder> folder, const RecoveredDocument& document,
                                       JournalWriter::Broken broken, JournalLimits limits)
{
    const JournalWriter::Place place{document.nextRecord, document.nextSegment};
    return std::shared_ptr<Journal>(new Journal(std::move(folder), place, std::move(broken), limits, document.history.present));
}

void Journal::changed(const Mesh& mesh, const MeshDelta& delta, JournalStep step, std::optional<Stroke> stroke)
{
    m_writer->add(ChangeRecord{m_present++, std::move(step), imageOf(mesh, delta)});
    if (stroke)
        m_writer->add(StrokeRecord{std::move(*stroke)});
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
