#pragma once

#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_player.h"
#include "core/operations/model_command.h"
#include "core/sculpt/sculptor.h"

namespace core
{
/// The teacher's model: the lesson's start plus the strokes played so far. Every change can be undone bit for bit.
/// Steps can therefore be repeated, and a step begins with the same model no matter how it is reached. Thread: the mesh
/// thread.
class LessonPlayback
{
public:
    /// Starts at the beginning of the first step. `path`: path of the lesson, for errors. Throws FileError, or
    /// LessonError::Unsound if the start model cannot be sculpted. Cost: buildMesh().
    LessonPlayback(std::shared_ptr<const Lesson> lesson, std::filesystem::path path);

    const Lesson& lesson() const { return *m_lesson; }
    const Mesh& mesh() const { return m_sculptor->mesh(); }
    const Sculptor& sculptor() const { return *m_sculptor; }
    std::size_t stepIndex() const { return m_step; }
    const LessonStep& step() const { return m_lesson->steps[m_step]; }
    /// Returns the number of strokes and commands of this step that are done.
    std::size_t done() const { return m_done.size() - m_before.back(); }

    /// Executes one cue from LessonPlayer; all cues must be passed in order. Throws LessonError and leaves the model
    /// unchanged: Strokes if a stroke does not fit the model's size, Refused if a command cannot be done.
    void apply(const LessonCue& cue);
    /// Undoes the step's last stroke or command, or the stroke that is in progress. Returns false at the step's start.
    bool undoLast();
    /// Executes the step's next stroke or command. Returns whether it changed the model. Precondition: there is one,
    /// and no stroke is in progress. Throws as apply(); so do finish(), goTo() and target().
    bool playNext();
    /// Executes the rest of the step. A stroke that is in progress is undone and played again as a whole.
    void finish();
    /// Undoes the whole step.
    void rewind();
    /// Goes to the start of a step, forward or backward, by executing or undoing everything in between.
    void goTo(std::size_t step);

    /// Returns the shape that the step's checkpoint is compared with. Precondition: the checkpoint has a target, and no
    /// stroke is in progress. Cost: playing and undoing the rest of the step, unless the target is a file.
    TriangleMesh target();

    /// The current model, ready to be sculpted, and the lesson's start. No other function may be called after
    /// release().
    struct Released
    {
        std::unique_ptr<Sculptor> sculptor;
        std::shared_ptr<const Snapshot> start;
    };
    Released release() && { return {std::move(m_sculptor), std::move(m_start)}; }

private:
    void begin(const StrokeSettings& settings);
    void run(FileCommand entry);
    void play(const FileEntry& entry);
    LessonError errorHere(LessonError::Kind kind, StrokeFileError problem) const;

    std::shared_ptr<const Lesson> m_lesson;
    std::filesystem::path m_path;
    std::unique_ptr<Sculptor> m_sculptor;
    std::shared_ptr<const Snapshot> m_start;
    std::size_t m_step = 0;
    std::vector<MeshDelta> m_done;           ///< one delta per finished stroke or command, of all steps
    std::vector<std::size_t> m_before = {0}; ///< number of deltas at the start of each step up to this one
};
} // namespace core
