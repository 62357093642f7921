#pragma once

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_player.h"
#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"

namespace core
{
/// The teacher's model: what a lesson's strokes make of its start. Every change can be taken back to the bit, so that a
/// step may be seen again, and it begins alike whenever it is come to. Lives on the mesh thread.
class LessonPlayback
{
public:
    /// At the start of the first step. `path`: of the lesson, for errors. Throws FileError, and LessonError::Unsound
    /// where the start is none that can be sculpted. Cost: buildMesh().
    LessonPlayback(std::shared_ptr<const Lesson> lesson, std::filesystem::path path);

    const Lesson& lesson() const { return *m_lesson; }
    const Mesh& mesh() const { return m_sculptor->mesh(); }
    const Sculptor& sculptor() const { return *m_sculptor; }
    std::size_t stepIndex() const { return m_step; }
    const LessonStep& step() const { return m_lesson->steps[m_step]; }
    /// Strokes and commands of the step that are done.
    std::size_t done() const { return m_done.size() - m_before.back(); }

    /// Does what the player hands out, in its order. Throws LessonError: Strokes where a stroke is not for a model of
    /// this size, Refused; then it was not done.
    void apply(const LessonCue& cue);
    /// What was done last in the step, or is under way. False at the step's start.
    bool undoLast();
    /// Does the step's next stroke or command, which there is; nothing is under way. Whether that changed the model.
    bool playNext();
    /// Does the rest of the step; what is under way is done anew.
    void finish();
    /// Back to the step's start.
    void rewind();
    /// The step's start, whichever way it is come to: what lies between is done or taken back.
    void goTo(std::size_t step);

    /// What the step's checkpoint wants to be come near to; between strokes. Cost: the rest of the step, unless it is a
    /// file.
    TriangleMesh target();

    /// The model as it is, to be sculpted on, and the lesson's start. The last that is asked of the stage.
    struct Released
    {
        std::unique_ptr<Sculptor> sculptor;
        std::shared_ptr<const Snapshot> start;
    };
    Released release() && { return {std::move(m_sculptor), std::move(m_start)}; }

private:
    void begin(const StrokeSettings& settings);
    void run(ModelCommand command);
    void play(const FileEntry& entry);
    LessonError errorHere(LessonError::Kind kind, StrokeFileError problem) const;

    std::shared_ptr<const Lesson> m_lesson;
    std::filesystem::path m_path;
    std::unique_ptr<Sculptor> m_sculptor;
    std::shared_ptr<const Snapshot> m_start;
    std::size_t m_step = 0;
    std::vector<MeshDelta> m_done;           ///< of all steps
    std::vector<std::size_t> m_before = {0}; ///< of the steps up to this one: how many were done before
};
} // namespace core
