#pragma once

#include "core/analysis/mesh_check.h"
#include "core/print/wall_thickness.h"

#include <optional>

namespace core
{
/// Size of the space in which a printer can print, mm: x and y of its bed, and the height z.
struct PrintBed
{
    double x = 0, y = 0, z = 0;
};

struct PrintLimits
{
    static constexpr double defaultNozzle = 0.4, linesPerWall = 2;
    static constexpr double maxWall = 10; ///< largest minimum wall that a user may ask for, mm
    /// Diameter up to which walls are measured in every part of a face, mm.
    static constexpr double largestBall = maxWall;
    /// Height above the lowest point that counts as touching the bed, mm. Smaller than the height of any first layer.
    static constexpr double bedTolerance = 0.01;
    /// Volumes below which slicers take a model for one in inches or in metres, mm^3 (PrusaSlicer's thresholds).
    static constexpr double inchVolume = 8, metreVolume = 0.001;
    /// Longest side below which a model was probably made in inches or in metres, mm.
    static constexpr double inchSide = 20, metreSide = 1;

    double minWall = linesPerWall * defaultNozzle; ///< least thickness of a wall, mm, at most maxWall
    /// Largest angle from the vertical at which a face may lean out, degrees, 0 to 90.
    double overhang = 45;
    PrintBed bed = {};
};

/// The slow measurements of a model. Checking them against limits is fast.
struct PrintMeasures
{
    TriangleMesh mesh; ///< the model in mm, Y up
    MeshReport report;
    std::optional<WallThickness> walls; ///< missing unless the model bounds a solid
};
/// Cost: that of checkMesh() and wallThickness().
PrintMeasures measureForPrint(TriangleMesh mesh, const JobControl& control = {});

/// A connected set of faces with the same fault.
struct PrintPlace
{
    Slot face = 0;             ///< worst face
    Vec3 point = Vec3::Zero(); ///< centre of the worst face, or the thinnest point found on it, mm
    Vec3 normal = Vec3::Zero();
    double worst = 0; ///< worst value: thickness in mm, or degrees by which a face leans out
    double area = 0;  ///< area of all faces of the place, mm^2
};

/// The places of one kind of fault by area, largest first, at most maxPlaces. `count` and `area` are for all places.
struct PrintFault
{
    static constexpr std::size_t maxPlaces = 20;

    std::vector<PrintPlace> places;
    std::size_t count = 0; ///< number of all places
    double area = 0;
};

enum class BedFit { AsItStands, Turned, Not }; ///< Turned: fits after a quarter turn about the vertical

struct PrintReport
{
    double area = 0; ///< area of the whole surface, mm^2
    /// Least thickness, mm. Missing if thickness was not measured or no face has an opposite face.
    std::optional<double> thinnest;
    PrintFault thin;      ///< places thinner than the limit
    PrintFault overhangs; ///< places that lean out more than the limit, except those on the bed
    double baseArea = 0;  ///< area of the flat surface that touches the bed, mm^2
    BedFit fit = BedFit::AsItStands;
};
/// Returns whether a thin place is larger than a square whose side is the limit. Smaller places are slivers in creases
/// and tips of edges, which a printer rounds.
bool hasThinWalls(const PrintReport& report, const PrintLimits& limits);
/// Checks a model that stands on its lowest point. Cost: O(faces).
PrintReport checkForPrint(const PrintMeasures& measures, const PrintLimits& limits);

/// The unit that a slicer would assume for a model of this volume, by PrusaSlicer's thresholds, which other slicers use
/// too.
enum class UnitDoubt { None, Inches, Metres };
UnitDoubt unitDoubtOf(double volume);
/// Returns a likelier unit than mm for a small model. None unless unitDoubtOf() doubts the volume or the longest side
/// is below PrintLimits::inchSide; then Metres if that side is below metreSide, else Inches.
UnitDoubt guessedUnit(double volume, double longestSide);

enum class PrintPicture { Thickness, Overhang };
/// Returns a value for each vertex, for a coloured picture. Thickness: the least thickness of the vertex's faces, and
/// of the parts and ridges nearest to the vertex, mm; infinity if not measured. Overhang: the largest angle from the
/// vertical at which one of its faces leans out, degrees (90 for a ceiling, -90 for upward faces and those on the bed).
std::vector<float> pictureOf(const PrintMeasures& measures, PrintPicture picture);
} // namespace core
