package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import lightning.base.work.Progress;
import lightning.bench.accuracy.EditTurns;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.TimeSamples;
import lightning.render.RenderOptions;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;

/** Benchmark of the costs of indirect light as a function of lights, gather points, rays, objects, triangles and pixels, on
 * generated rooms. */
final class IndirectGrowthBench {
    private static final PictureSize SIZE = new PictureSize(960, 540);
    private static final PictureSize QUICK_SIZE = new PictureSize(64, 36);
    private static final List<PictureSize> SIZES = List.of(new PictureSize(240, 135), new PictureSize(480, 270), SIZE,
            new PictureSize(1920, 1080), new PictureSize(3840, 2160));
    private static final List<PictureSize> QUICK_SIZES = List.of(new PictureSize(32, 18), QUICK_SIZE);
    private static final int BALLS = 12;
    /** Predicted milliseconds per pixel of a point. */
    private static final double MS_PER_PIXEL = 8e-3;

    private final BenchSettings settings;
    private final ResultCollector ledger;
    private final PictureSize fixedSize;
    private final List<BenchPart> parts = new ArrayList<>();

    IndirectGrowthBench(BenchSettings settings, ResultCollector ledger) {
        this.settings = settings;
        this.ledger = ledger;
        fixedSize = settings.quick() ? QUICK_SIZE : SIZE;
    }

    /** Returns the parts, one per point of each curve. */
    List<BenchPart> parts() {
        boolean quick = settings.quick();
        for (int lights : quick ? List.of(1, 4) : List.of(1, 2, 4, 8, 16, 32, 64)) {
            add("lights", "room of 12 balls", lights, fixedSize, _ -> lights, () -> room(fixedSize).withBalls(BALLS, lights));
        }
        for (int spacing : quick ? List.of(16, 4) : List.of(32, 16, 8, 4)) {
            add("gather points", "room of 12 balls, one light, spacing 32 to 4", spacing, fixedSize, EditTurns::points,
                    () -> room(IndirectSettings.DEFAULT.withSpacing(spacing)).withBalls(BALLS, 1));
        }
        for (int rays : quick ? List.of(16, 64) : List.of(16, 64, 256)) {
            add("rays", "room of 12 balls, one light", rays, fixedSize, _ -> rays,
                    () -> room(IndirectSettings.DEFAULT.withRays(rays)).withBalls(BALLS, 1));
        }
        for (int balls : quick ? List.of(1, 8) : List.of(1, 10, 100, 1000)) {
            add("objects", "room of balls, one light", balls, fixedSize, _ -> balls, () -> room(fixedSize).withBalls(balls, 1));
        }
        for (int triangles : quick ? List.of(1000, 10_000) : List.of(1000, 10_000, 100_000, 1_000_000)) {
            add("triangles", "room with a mesh, one light", triangles, fixedSize, _ -> triangles,
                    () -> room(fixedSize).withMesh(triangles));
        }
        for (PictureSize size : quick ? QUICK_SIZES : SIZES) {
            add("pixels", "room of 12 balls, one light", size.pixels(), size, _ -> size.pixels(), () -> room(size).withBalls(BALLS, 1));
        }
        return parts;
    }

    private GeneratedRooms room(PictureSize size) {
        return new GeneratedRooms(settings.seed(), size, IndirectSettings.DEFAULT);
    }

    private GeneratedRooms room(IndirectSettings indirect) {
        return new GeneratedRooms(settings.seed(), fixedSize, indirect);
    }

    /** @param scene creates the scene when it is measured: meshes of many triangles take memory */
    private void add(String along, String text, long value, PictureSize size, ToLongFunction<EditTurns> at, Supplier<Scene> scene) {
        parts.add(new BenchPart("growth of indirect light with " + along + ", " + value, 200 + MS_PER_PIXEL * size.pixels(),
                progress -> ledger.indirect().add(along, text, point(scene.get(), size, at, progress))));
    }

    private IndirectGrowth.Point point(Scene scene, PictureSize size, ToLongFunction<EditTurns> at, Progress progress) {
        RenderOptions options = RenderOptions.DEFAULT.withThreads(settings.threads());
        List<PaperCase> cases = ModernCases.of(scene);
        List<Scene> afters = List.of(after(cases, ModernCases.INTENSITY), after(cases, ModernCases.POSITION));
        EditTurns with = EditTurns.of(scene, afters, options, settings.repetitions(), false, progress);
        EditTurns without = EditTurns.of(scene.withoutIndirect(), List.of(), options, settings.repetitions(), false,
                progress.cancellationOnly());
        return new IndirectGrowth.Point(at.applyAsLong(with), with.points(), with.surfels(),
                (with.bytes() - without.bytes()) / (double) size.pixels(), TimeSamples.of(with.first()), TimeSamples.of(without.first()),
                TimeSamples.of(with.edits().get(0)), TimeSamples.of(with.edits().get(1)));
    }

    private static Scene after(List<PaperCase> cases, String name) {
        return cases.stream().filter(edit -> edit.name().equals(name)).findFirst().orElseThrow().after();
    }
}
