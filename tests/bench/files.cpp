// Measures opening and exporting a model of a million vertices, beside a plain read and write of the same number of
// bytes and beside Assimp's import of the same file.
#include "tests/bench/bench_models.h"

#include "core/io/mesh_io.h"
#include "core/mesh/mesh_builder.h"

#include <assimp/Importer.hpp>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace
{
namespace fs = std::filesystem;

constexpr core::Slot cuts = 317; // cuts of the icosahedron's edges: 1,004,892 vertices
constexpr const char* labels[] = {"STL", "PLY", "GLB", "OBJ", "3MF"};
constexpr const char* endings[] = {"stl", "ply", "glb", "obj", "3mf"};

/// Returns the duration of `work` in milliseconds.
template <typename Work> double timeOf(Work work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Returns the shortest duration of each function in ms. The functions run alternately, several times.
template <typename First, typename Second> std::pair<double, double> timesOf(First first, Second second)
{
    constexpr int rounds = 7;
    std::pair best(timeOf(first), timeOf(second));
    for (int i = 1; i < rounds; ++i)
        best = {std::min(best.first, timeOf(first)), std::min(best.second, timeOf(second))};
    return best;
}

void require(bool done)
{
    if (!done)
        throw std::runtime_error("the file system refuses");
}

/// Reads the whole file into newly mapped memory, on one core.
void readPlainly(const fs::path& path)
{
    const std::size_t size = fs::file_size(path);
    void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    require(memory != MAP_FAILED);
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::size_t got = 0;
    for (ssize_t part = 1; got < size && part > 0; got += static_cast<std::size_t>(part))
        require((part = ::read(file, static_cast<char*>(memory) + got, size - got)) >= 0);
    ::close(file);
    ::munmap(memory, size);
    require(got == size);
}

/// Writes `size` bytes and flushes them to the disk.
void writePlainly(const fs::path& path, std::size_t size)
{
    const auto buffer = std::make_unique<char[]>(size);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    std::size_t done = 0;
    for (ssize_t part = 1; done < size && part > 0; done += static_cast<std::size_t>(part))
        require((part = ::write(file, buffer.get() + done, size - done)) >= 0);
    require(done == size && ::fsync(file) == 0);
    ::close(file);
}

/// Returns the ball scaled to a diameter of 100 mm.
core::TriangleMesh scaled(core::TriangleMesh ball)
{
    for (core::Vec3f& p : ball.points)
        p *= 50;
    return ball;
}

/// Measures one format. The file that is read has its faces in random order, the worst case. The mesh that is written
/// is in a document's order.
void files(benchmark::State& state)
{
    const auto format = static_cast<std::size_t>(state.range(0));
    state.SetLabel(labels[format]);
    const fs::path folder = fs::temp_directory_path() / ("fettle_bench_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const fs::path path = folder / ("shuffled." + std::string(endings[format])),
                   written = folder / ("ball." + std::string(endings[format]));
    const core::TriangleMesh ball = scaled(bench::geodesicSphere(cuts));
    core::writeMesh(path, bench::shuffled(ball));
    const std::size_t size = fs::file_size(path);
    for ([[maybe_unused]] auto round : state) {
        const auto [plain, read] =
            timesOf([&] { readPlainly(path); }, [&] { benchmark::DoNotOptimize(core::readMesh(path)); });
        const auto [plainWrite, write] =
            timesOf([&] { writePlainly(folder / "plain", size); }, [&] { core::writeMesh(written, ball); });
        state.counters["megabytes"] = static_cast<double>(size) * 1e-6;
        state.counters["plain"] = plain;
        state.counters["read"] = read;
        state.counters["read_plain"] = read / plain;
        state.counters["plain_write"] = plainWrite;
        state.counters["write"] = write;
        const core::TriangleMesh mesh = core::readMesh(path);
        state.counters["build"] = timeOf([&] { require(core::buildMesh(mesh, false).mesh != nullptr); });
        Assimp::Importer importer;
        state.counters["assimp"] = timeOf([&] { benchmark::DoNotOptimize(importer.ReadFile(path.string(), 0)); });
        state.SetIterationTime(read * 1e-3);
    }
    fs::remove_all(folder);
}
BENCHMARK(files)->DenseRange(0, 4)->Iterations(1)->UseManualTime();
} // namespace
