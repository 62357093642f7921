#pragma once

#include "core/operations/model_command.h"
#include "tests/support/fuzz_tally.h"
#include "tests/support/stroke_fuzzer.h"

#include <optional>
#include <variant>
#include <vector>

/// What a run of the fuzzer begins with.
struct FuzzStart
{
    std::string shape;
    core::TriangleMesh mesh;
    /// The mesh is symmetric about this plane, bit for bit, and shall stay so: every stroke is mirrored there.
    core::Symmetry plane = core::Symmetry::None;
};

/// Every shape that the fuzzer knows, about one to four units large.
std::vector<FuzzStart> fuzzShapes();
/// Made symmetric.
FuzzStart symmetrized(const FuzzStart& start, core::Symmetry plane);

/// One mesh, sculpted at random until its dabs are used up, it has grown large, or nearly all of it is gone. After each
/// dab the octree is compared with the mesh and the symmetry is checked, after each few all pairs of faces are tested,
/// and CGAL judges; at the end everything is undone, redone, and, if asked, done again from the start without what was
/// undone in between.
class FuzzRun
{
public:
    /// FETTLE_TRACE=1 in the environment: says what each dab did.
    FuzzRun(const FuzzStart& start, std::uint64_t seed, FuzzTally& tally);

    enum class AtEnd { Undo, UndoAndReplay };
    void go(std::uint64_t dabs, AtEnd atEnd);

    bool ok() const { return m_problem.empty(); }
    /// What went wrong first, and how to do it again.
    const std::string& problem() const { return m_problem; }
    /// To begin another run with. Nothing if a document would not take the surface as it is.
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
    std::vector<std::uint64_t> m_states; ///< after each of them
    std::vector<core::MeshDelta> m_undo;
    std::uint64_t m_startState;
    bool m_trace;
    int m_dabs = 0, m_nextPairCheck = 0, m_nextJudge = 0;
};
