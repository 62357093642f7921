#pragma once

#include "core/operations/model_command.h"
#include "tests/support/fuzz_tally.h"
#include "tests/support/stroke_fuzzer.h"

#include <optional>
#include <variant>
#include <vector>

/// The start of a fuzzer run: a mesh and its required symmetry.
struct FuzzStart
{
    std::string shape;
    core::TriangleMesh mesh;
    /// plane about which the mesh is symmetric bit for bit; every stroke is mirrored there, so the symmetry must
    /// persist
    core::Symmetry plane = core::Symmetry::None;
};

/// Returns the fuzzer's start shapes, about one to four units large.
std::vector<FuzzStart> fuzzShapes();
/// Returns a copy of `start` that is symmetric about `plane`.
FuzzStart symmetrized(const FuzzStart& start, core::Symmetry plane);

/// Sculpts one mesh at random until its dabs are used up, it has grown large, or nearly all of it is gone.
/// After each dab it compares the octree with the mesh and checks the symmetry. Every few dabs all pairs of faces are
/// tested for intersection, and CGAL judges the mesh.
/// At the end it undoes and redoes everything. On request it also replays the steps from the start, without the undone
/// ones.
class FuzzRun
{
public:
    /// FETTLE_TRACE=1 in the environment prints the report of each dab.
    FuzzRun(const FuzzStart& start, std::uint64_t seed, FuzzTally& tally);

    enum class AtEnd { Undo, UndoAndReplay };
    void go(std::uint64_t dabs, AtEnd atEnd);

    bool ok() const { return m_problem.empty(); }
    /// Returns the first problem found, with the steps to reproduce it. Empty if there is none.
    const std::string& problem() const { return m_problem; }
    /// Returns the final mesh as the start of another run, or nothing if a document would not accept its surface
    /// unchanged.
    std::optional<FuzzStart> grown() const;

private:
    using Step = std::variant<core::Stroke, core::ModelCommand>;

    void fail(const std::string& what);
    bool mayGoOn() const;
    core::Stroke nextStroke();
    core::ModelCommand nextCommand();
    void sculpt(core::Stroke stroke);
    void command(const core::ModelCommand& command);
    void done(core::MeshDelta delta, Step step);
    void trace(const core::StrokeSettings& settings, const core::DabReport& report) const;
    void undoForGood();
    void checkAfterSample();
    void checkIndex(const char* when);
    void checkPairs(const char* when);
    void judge(const char* when);
    void walkHistory();
    void replay();

    const FuzzStart& m_start;
    std::uint64_t m_seed;
    StrokeFuzzer m_fuzzer;
    FuzzTally& m_tally;
    core::Sculptor m_sculptor;
    std::string m_where, m_problem;
    std::vector<Step> m_steps;
    std::vector<std::uint64_t> m_states; ///< hash of the mesh after each step
    std::vector<core::MeshDelta> m_undo;
    std::uint64_t m_startState;
    bool m_trace;
    int m_dabs = 0, m_nextPairCheck = 0, m_nextJudge = 0;
};
