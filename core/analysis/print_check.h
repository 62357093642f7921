#pragma once

#include "core/analysis/mesh_check.h"
#include "core/analysis/wall_thickness.h"

#include <optional>

namespace core
{
/// What a printer holds, mm: width and depth of its bed, and how high it prints.
struct PrintBed
{
    double x = 0, y = 0, z = 0;
};

struct PrintLimits
{
    static constexpr double defaultNozzle = 0.4, linesPerWall = 2;
    static constexpr double maxWall = 10; ///< mm, that may be asked for
    /// mm; thicker walls are measured by rays alone.
    static constexpr double largestBall = maxWall;
    /// mm above the lowest point that count as the bed: less than any first layer is high.
    static constexpr double bedTolerance = 0.01;
    /// Below these volumes, in mm^3, slicers take a model for one in inches, and in metres (PrusaSlicer's).
    static constexpr double inchVolume = 8, metreVolume = 0.001;
    static constexpr double inchSide = 20, metreSide = 1; ///< mm; a longest side below these is rarely meant so

    double minWall = linesPerWall * defaultNozzle; ///< mm, at most maxWall
    double overhang = 45;                          ///< degrees that a face may lean out, from the vertical; 0 to 90
    PrintBed bed;
};

/// All that takes long, of a model; what limits say of it does not.
struct PrintMeasures
{
    TriangleMesh mesh; ///< mm, Y up
    MeshReport report;
    std::optional<WallThickness> walls; ///< missing unless it bounds a solid
};
/// Costs: checkMesh() and wallThickness().
PrintMeasures measureForPrint(TriangleMesh mesh, const JobControl& control = {});

/// Faces that hang together and have the same fault.
struct PrintPlace
{
    Slot face = 0;             ///< the worst of them
    Vec3 point = Vec3::Zero(); ///< its centre
    Vec3 normal = Vec3::Zero();
    double worst = 0; ///< thickness in mm, or degrees that it leans out
    double area = 0;  ///< of all of them, mm^2
};

/// Places by area, the largest first, no more than maxPlaces; the sums are of all.
struct PrintFault
{
    static constexpr std::size_t maxPlaces = 20;

    std::vector<PrintPlace> places;
    std::size_t count = 0; ///< of places
    double area = 0;
};

enum class BedFit { AsItStands, Turned, Not }; ///< Turned: by a quarter about the vertical

struct PrintReport
{
    double area = 0; ///< mm^2, of the whole surface
    /// Mm; missing where thickness was not measured or nothing is opposite.
    std::optional<double> minByRays, minByBalls;
    PrintFault thin;      ///< thinner than the limit, by either method
    PrintFault overhangs; ///< lean out more than the limit; those on the bed do not count
    double baseArea = 0;  ///< mm^2 of flat surface on the bed, looking down
    BedFit fit = BedFit::AsItStands;
};
/// Returns whether a place is thin on more than a square of the limit. Smaller ones are slivers in creases and tips of
/// edges, which a printer rounds.
bool hasThinWalls(const PrintReport& report, const PrintLimits& limits);
/// Of a model that stands on its lowest point. Cost: O(faces).
PrintReport checkForPrint(const PrintMeasures& measures, const PrintLimits& limits);

/// What a slicer would take a model of that volume for. By PrusaSlicer's thresholds, which others have, too.
enum class UnitDoubt { None, Inches, Metres };
UnitDoubt unitDoubtOf(double volume);
/// Returns the unit in which a model was made that is too small for slicers in millimetres, or shorter than
/// PrintLimits::inchSide: below metreSide metres are likelier than inches.
UnitDoubt guessedUnit(double volume, double longestSide);

enum class PrintPicture { Thickness, Overhang };
/// By vertex, for a picture: the least thickness of its faces in mm, or the most that one of them leans out, degrees
/// from the vertical (90: a ceiling, -90: a floor; on the bed -90). Infinity of a thickness that was not measured.
std::vector<float> pictureOf(const PrintMeasures& measures, PrintPicture picture);
} // namespace core
