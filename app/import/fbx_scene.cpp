// Source: Autodesk, FBX SDK Help, "Computing transformation matrices":
//   world = parent's world * T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1,
// and for the model's own mesh, but not for its children, OT * OR * OS behind it. Assimp (5.2 to 6.0) gives the factors
// that are not the identity as a chain of nodes, "name_$AssimpFbx$_PreRotation" and so on, that ends in the node of the
// model; OT, OR and OS are taken back by further nodes in front of its children.
#include "app/import/fbx_scene.h"

#include <assimp/scene.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace app
{
namespace
{
using Inherit = FbxModel::Inherit;

/// Returns the factor that a node of the chain stands for; empty for the node of a model, which alone has metadata.
std::string_view factorOf(const aiNode& node)
{
    constexpr std::string_view tag = "_$AssimpFbx$_";
    const std::string_view name(node.mName.C_Str(), node.mName.length);
    const std::size_t at = name.rfind(tag);
    return node.mMetaData || at == std::string_view::npos ? std::string_view() : name.substr(at + tag.size());
}

bool isGeometric(std::string_view factor)
{
    return factor.starts_with("Geometric");
}

bool isGeometricInverse(std::string_view factor)
{
    return isGeometric(factor) && factor.ends_with("Inverse");
}

template <class Value> std::optional<Value> valueOf(const aiMetadata* data, const char* key)
{
    Value value{};
    return data && data->Get(key, value) ? std::optional(value) : std::nullopt;
}

/// Returns the node that ends a model's chain, which has its name, its metadata and its meshes.
const aiNode& endOf(const aiNode& first)
{
    const aiNode* node = &first;
    while (!factorOf(*node).empty() && node->mNumChildren == 1)
        node = node->mChildren[0];
    return *node;
}

/// A model's chain, put together.
struct Transforms
{
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();    ///< against its parent
    Eigen::Matrix4d ofMeshes = Eigen::Matrix4d::Identity(); ///< against itself
};

Transforms transformsOf(const aiNode& first, const FbxModel& model)
{
    const aiNode* const end = &endOf(first);
    Transforms transforms;
    for (const aiNode* part = &first;; part = part->mChildren[0]) {
        const std::string_view factor = factorOf(*part);
        if (model.hasActiveRotations || (factor != "PreRotation" && factor != "PostRotation"))
            (isGeometric(factor) ? transforms.ofMeshes : transforms.local) *= matrixOf(*part);
        if (part == end)
            return transforms;
    }
}

/// A model's place in the world, and what its children inherit of it.
struct ModelPlace
{
    Eigen::Matrix4d world, withoutScale;
    Eigen::Vector3d scale = Eigen::Vector3d::Ones();       ///< of itself times what it inherits by its axes, with signs
    Eigen::Vector3d scaleBefore = Eigen::Vector3d::Ones(); ///< of those from which an Rrs child inherits
    bool isVisible = true;
};

/// Returns the matrix without its scale, the mirrors of which go with it. A scale of nothing cannot be taken back.
Eigen::Matrix4d unscaled(Eigen::Matrix4d matrix, const Eigen::Vector3d& scale)
{
    for (int axis = 0; axis < 3; ++axis)
        if (scale[axis] != 0)
            matrix.col(axis) /= scale[axis];
    return matrix;
}

ModelPlace placeOf(const FbxModel& model, Eigen::Matrix4d local, const ModelPlace& parent)
{
    ModelPlace place;
    if (model.inherit != Inherit::Usual) {
        place.scaleBefore = model.inherit == Inherit::ComponentWise ? parent.scale : parent.scaleBefore;
        for (int axis = 0; axis < 3; ++axis)
            local.col(axis) *= place.scaleBefore[axis];
        local.topRightCorner<3, 1>().array() *= parent.scale.array();
    }
    const Eigen::Matrix4d& above = model.inherit == Inherit::Usual ? parent.world : parent.withoutScale;
    place.scale = model.scale.cwiseProduct(place.scaleBefore);
    place.world = above * local;
    place.withoutScale = above * unscaled(local, place.scale);
    place.isVisible = model.isVisible && (parent.isVisible || !model.inheritsVisibility);
    return place;
}

/// Walks along the models and Assimp's nodes of them, and adds what they place.
class SceneWalk
{
public:
    SceneWalk(const std::vector<FbxModel>& models, SceneMesh& mesh) : m_models(models), m_mesh(mesh) {}

    /// Adds the models below one, of levels of detail the first that shows anything. `above`: Assimp's node whose
    /// children they are.
    void addBelow(const aiNode& above, const FbxModel& model, const ModelPlace& place)
    {
        auto next = model.below.begin();
        const std::size_t before = m_mesh.faces();
        for (unsigned i = 0; i < above.mNumChildren && !(model.isLodGroup && m_mesh.faces() > before); ++i) {
            const aiNode& first = *above.mChildren[i];
            next = std::find_if(next, model.below.end(),
                                [&](std::size_t index) { return isNamed(endOf(first), m_models[index].name); });
            if (next == model.below.end())
                throw std::runtime_error("the records of its models cannot be followed");
            add(first, m_models[*next++], place);
        }
    }

    /// Returns how many meshes the models lack that they should have.
    std::size_t missing() const { return m_missing; }

private:
    /// Returns whether the node has that name, or begins with the first 1,000 bytes of it; there may be a number behind
    /// it, by which Assimp tells equal ones apart. Assimp passes over models that it cannot read. A name of 1,024 bytes
    /// or more, with what Assimp adds to it, may be missing from its node: such a file is refused.
    static bool isNamed(const aiNode& node, std::string_view name)
    {
        constexpr std::size_t kept = 1000;
        return std::string_view(node.mName.C_Str(), node.mName.length).starts_with(name.substr(0, kept));
    }

    void add(const aiNode& first, const FbxModel& model, const ModelPlace& parent)
    {
        const Transforms transforms = transformsOf(first, model);
        const ModelPlace place = placeOf(model, transforms.local, parent);
        const aiNode* above = &endOf(first);
        if (place.isVisible && model.isShown) {
            m_mesh.addMeshesOf(*above, place.world * transforms.ofMeshes, model.meshes > 0);
            m_missing += std::max<std::size_t>(model.meshes, above->mNumMeshes) - above->mNumMeshes;
        }
        while (above->mNumChildren == 1 && isGeometricInverse(factorOf(*above->mChildren[0])))
            above = above->mChildren[0];
        addBelow(*above, model, place);
    }

    const std::vector<FbxModel>& m_models;
    SceneMesh& m_mesh;
    std::size_t m_missing = 0;
};

/// Returns the turn, or the mirror, that makes the axis that the file has as its right one X, its up one Y, its front
/// one Z. Where the file's axes are none, up alone counts.
Eigen::Matrix3d axesOf(const aiMetadata* data)
{
    const auto number = [data](const char* key, std::int32_t usual) {
        return valueOf<std::int32_t>(data, key).value_or(usual);
    };
    const std::array axes{number("CoordAxis", 0), number("UpAxis", 1), number("FrontAxis", 2)};
    const std::array signs{number("CoordAxisSign", 1), number("UpAxisSign", 1), number("FrontAxisSign", 1)};
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    for (int row = 0; row < 3; ++row)
        if (const std::int32_t axis = axes[row]; axis >= 0 && axis < 3)
            matrix(row, axis) = signs[row] < 0 ? -1 : 1;
    if (matrix.determinant() != 0)
        return matrix;
    if (axes[1] == 2)
        return Eigen::Matrix3d{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    return Eigen::Matrix3d::Identity();
}
} // namespace

std::size_t addFbxScene(const aiScene& scene, const std::vector<FbxModel>& models, SceneMesh& mesh)
{
    constexpr double millimetresInCentimetre = 10;
    const auto factor = static_cast<double>(valueOf<float>(scene.mMetaData, "UnitScaleFactor").value_or(1));
    if (!std::isfinite(factor) || factor <= 0)
        throw std::runtime_error("UnitScaleFactor is no positive number");
    const double unit = millimetresInCentimetre * factor;
    ModelPlace root{.world = Eigen::Matrix4d::Identity(), .withoutScale = Eigen::Matrix4d::Identity()};
    root.world.topLeftCorner<3, 3>() = unit * axesOf(scene.mMetaData);
    root.withoutScale = root.world;
    const aiNode& top = *scene.mRootNode; // from 5.4 on Assimp puts the axes into its transform, half of them wrongly
    mesh.addMeshesOf(top, root.world);
    SceneWalk walk(models, mesh);
    walk.addBelow(top, models.front(), root);
    return walk.missing();
}
} // namespace app
