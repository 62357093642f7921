#include "core/lesson/lesson_playback.h"

#include "core/mesh/mesh_builder.h"

#include <cassert>

namespace core
{
LessonPlayback::LessonPlayback(std::shared_ptr<const Lesson> lesson, std::filesystem::path path)
    : m_lesson(std::move(lesson))
    , m_path(std::move(path))
{
    const auto* const file = std::get_if<std::string>(&m_lesson->start);
    BuildResult built = buildMesh(file ? modelIn(*m_lesson, *file) : starterModel(std::get<Starter>(m_lesson->start)));
    if (!built.mesh) {
        LessonError error(LessonError::Kind::Unsound, m_path);
        error.file = file ? *file : std::string();
        error.report = built.report;
        error.max = static_cast<double>(built.unsnappable);
        throw error;
    }
    m_start = snapshotOf(*built.mesh);
    m_sculptor = std::make_unique<Sculptor>(std::move(built.mesh));
}

LessonError LessonPlayback::errorHere(LessonError::Kind kind, StrokeFileError problem) const
{
    LessonError error(kind, m_path);
    error.file = step().strokesFile;
    error.step = m_step;
    problem.stroke = done();
    error.strokes = std::move(problem);
    return error;
}

void LessonPlayback::begin(const StrokeSettings& settings)
{
    try {
        requireFit(std::get<Stroke>(step().strokes[done()]), mesh().lattice());
    } catch (const StrokeFileError& problem) {
        throw errorHere(LessonError::Kind::Strokes, problem);
    }
    m_sculptor->beginStroke(settings);
}

void LessonPlayback::run(FileCommand entry)
{
    if (auto* const reset = std::get_if<Reset>(&entry.command))
        reset->start = m_start;
    ModelChange change = applyToCopy(mesh(), entry.command, {}, entry.part);
    if (change.refusal != ModelRefusal::None)
        throw errorHere(LessonError::Kind::Refused, StrokeFileError(StrokeFileError::Kind::UnknownValue));
    m_sculptor->swap(change.delta);
    m_done.push_back(std::move(change.delta));
}

void LessonPlayback::apply(const LessonCue& cue)
{
    assert(done() < step().strokes.size());
    if (const auto* const stroke = std::get_if<StrokeBegins>(&cue))
        begin(stroke->settings);
    else if (const auto* const sample = std::get_if<StrokeSample>(&cue))
        m_sculptor->addSample(*sample);
    else if (const auto* const command = std::get_if<FileCommand>(&cue))
        run(*command);
    else
        m_done.push_back(m_sculptor->endStroke());
}

bool LessonPlayback::undoLast()
{
    if (m_sculptor->strokeOpen())
        m_done.push_back(m_sculptor->endStroke());
    if (done() == 0)
        return false;
    m_sculptor->swap(m_done.back());
    m_done.pop_back();
    return true;
}

void LessonPlayback::play(const FileEntry& entry)
{
    if (const auto* const command = std::get_if<FileCommand>(&entry))
        return run(*command);
    const Stroke& stroke = std::get<Stroke>(entry);
    begin(stroke.settings);
    for (const StrokeSample& sample : stroke.samples)
        m_sculptor->addSample(sample);
    m_done.push_back(m_sculptor->endStroke());
}

bool LessonPlayback::playNext()
{
    assert(done() < step().strokes.size() && !m_sculptor->strokeOpen());
    play(step().strokes[done()]);
    return !m_done.back().empty();
}

void LessonPlayback::finish()
{
    if (m_sculptor->strokeOpen())
        undoLast();
    while (done() < step().strokes.size())
        playNext();
}

void LessonPlayback::rewind()
{
    while (undoLast()) {
    }
}

void LessonPlayback::goTo(std::size_t step)
{
    assert(step < m_lesson->steps.size());
    while (m_step < step) {
        finish();
        m_before.push_back(m_done.size());
        ++m_step;
    }
    rewind();
    while (m_step > step) {
        m_before.pop_back();
        --m_step;
        rewind();
    }
}

TriangleMesh LessonPlayback::target()
{
    assert(step().checkpoint.target && !m_sculptor->strokeOpen());
    if (const std::string& file = step().checkpoint.target->file; !file.empty())
        return modelIn(*m_lesson, file);
    const std::size_t before = done();
    finish();
    TriangleMesh target = extractMesh(mesh());
    while (done() > before)
        undoLast();
    return target;
}
} // namespace core
