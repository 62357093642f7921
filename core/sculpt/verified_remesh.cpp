#include "core/sculpt/verified_remesh.h"

#include "core/sculpt/verify/mesh_transaction.h"

namespace core
{
bool remeshVerified(DabContext& context, const std::function<RemeshCounts()>& remesh)
{
    MeshTransaction transaction(context.surface, context.region);
    const RemeshCounts counts = remesh();
    if (!transaction.commit())
        return false;
    context.count(counts);
    return true;
}

MeshEditor verifiedEditor(DabContext& context)
{
    const auto tryOperation = [&context](const std::function<void()>& operation) {
        if (context.request.work.isSpent()) {
            context.isCapped = true;
            return false;
        }
        const bool isDone = context.surface.tryOperation(operation);
        context.request.work.spend(context.surface.facesVisited());
        return isDone;
    };
    return MeshEditor(context.surface.mesh(), tryOperation, context.mirror);
}

void splitVerified(DabContext& context)
{
    MeshEditor edit = verifiedEditor(context);
    context.count(splitLongEdges(edit, context.region, context.bounds));
}
} // namespace core
