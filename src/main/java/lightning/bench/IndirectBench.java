package lightning.bench;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.bench.accuracy.EditTurns;
import lightning.bench.accuracy.HiddenEffectCost;
import lightning.bench.accuracy.ModernCases;
import lightning.bench.result.IndirectAbsence;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.TimeSamples;
import lightning.render.RenderOptions;
import lightning.render.measure.IndirectErrorMeter;
import lightning.render.measure.Timing;
import lightning.scene.IndirectSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.paper.PaperCase;

/**
 * Benchmark of indirect light: time against error, the first pass and edits of each scene, growth on generated rooms, and the cost of its
 * absence. Scenes without indirect light get the default settings.
 */
record IndirectBench(BenchSettings settings, ResultCollector ledger, RenderOptions options) {
    static final String ROOM = "room";
    private static final PictureSize ERROR_SIZE = new PictureSize(1920, 1080);
    private static final PictureSize QUICK_ERROR_SIZE = new PictureSize(48, 27);
    private static final PictureSize COST_SIZE = new PictureSize(1920, 1080);
    private static final PictureSize QUICK_COST_SIZE = new PictureSize(64, 36);
    private static final PictureSize ABSENCE_SIZE = new PictureSize(960, 540);
    /** Limits of the reference: sampled pixels and milliseconds. */
    private static final int PIXELS = 1000;
    private static final int QUICK_PIXELS = 16;
    private static final double REFERENCE_MS = 60_000;
    private static final List<Integer> SPACINGS = List.of(4, 8, 16, 32);
    private static final List<Integer> RAYS = List.of(16, 64, 256);
    private static final List<Integer> QUICK_RAYS = List.of(16, 64);
    private static final List<Integer> BOUNCES = List.of(1, 4);
    /** First passes per setting: settings differ by factors, so one suffices. */
    private static final int ERROR_REPETITIONS = 1;
    /** Most rays of a gather point over the square of the spacing; more would take minutes. */
    private static final double MAX_DENSITY = 4;
    /** Predicted milliseconds of each part of a scene. */
    private static final double ERROR_MS = 155_000;
    private static final double COST_MS = 75_000;
    private static final double ABSENCE_MS = 6000;
    private static final double QUICK_MS = 3000;
    private static final int ROOM_BALLS = 12;
    private static final int ROOM_LIGHTS = 4;

    IndirectBench(BenchSettings settings, ResultCollector ledger) {
        this(settings, ledger, RenderOptions.DEFAULT.withThreads(settings.threads()));
    }

    /** Returns the parts to measure for these scenes and a generated room. */
    List<BenchPart> parts(List<NamedScene> originals) {
        List<NamedScene> scenes = new ArrayList<>(originals.stream().map(IndirectBench::lit).toList());
        scenes.add(new NamedScene(ROOM, room(settings), null));
        List<BenchPart> parts = new ArrayList<>();
        for (NamedScene scene : scenes) {
            parts.add(new BenchPart(scene.name() + ", time against error of indirect light", ms(ERROR_MS),
                    progress -> ledger.indirect().add(accuracy(scene, progress))));
        }
        for (NamedScene scene : scenes) {
            parts.add(new BenchPart(scene.name() + ", cost of indirect light", ms(COST_MS), progress -> measureCost(scene, progress)));
        }
        for (NamedScene scene : scenes) {
            parts.add(new BenchPart(scene.name() + ", absence of indirect light", ms(ABSENCE_MS),
                    progress -> measureAbsence(scene, progress)));
        }
        parts.addAll(new IndirectGrowthBench(settings, ledger).parts());
        return parts;
    }

    /** Returns the generated room. */
    static Scene room(BenchSettings settings) {
        return new GeneratedRooms(settings.seed(), ERROR_SIZE, IndirectSettings.DEFAULT).withBalls(ROOM_BALLS, ROOM_LIGHTS);
    }

    private double ms(double full) {
        return settings.quick() ? QUICK_MS : full;
    }

    /** Returns the scene with indirect light: its own, or the default. */
    private static NamedScene lit(NamedScene scene) {
        IndirectSettings indirect = scene.scene().picture().indirect().orElse(IndirectSettings.DEFAULT);
        return new NamedScene(scene.name(), scene.withIndirect(Optional.of(indirect)), scene.file());
    }

    private IndirectAccuracy accuracy(NamedScene named, Progress progress) {
        PictureSize size = settings.quick() ? QUICK_ERROR_SIZE : ERROR_SIZE;
        Progress silent = progress.cancellationOnly();
        int repetitions = Math.min(ERROR_REPETITIONS, settings.repetitions());
        try (IndirectErrorMeter meter = new IndirectErrorMeter(size.of(named.scene()), options)) {
            int pixels = meter.traceReference(settings.quick() ? QUICK_PIXELS : PIXELS, REFERENCE_MS, silent);
            Timing without = meter.measureWithout(repetitions, silent);
            boolean background = named.scene().picture().indirect().orElseThrow().background();
            List<IndirectAccuracy.Point> points = new ArrayList<>();
            List<IndirectSettings> measured = measuredSettings(background);
            for (IndirectSettings indirect : measured) {
                IndirectErrorMeter.Measured result = meter.measure(indirect, repetitions, silent);
                points.add(new IndirectAccuracy.Point(indirect.spacing(), indirect.rays(), indirect.bounces(),
                        TimeSamples.of(result.time()), result.points(), result.surfels(), result.error()));
                progress.report(points.size(), measured.size());
            }
            return new IndirectAccuracy(named.name(), size.width(), size.height(), pixels, IndirectErrorMeter.RAYS,
                    IndirectErrorMeter.HIT_RAYS, TimeSamples.of(without), points);
        }
    }

    private List<IndirectSettings> measuredSettings(boolean background) {
        List<IndirectSettings> measured = new ArrayList<>();
        IndirectSettings initial = IndirectSettings.DEFAULT.withBackground(background);
        for (int spacing : SPACINGS) {
            for (int rays : settings.quick() ? QUICK_RAYS : RAYS) {
                if (rays <= MAX_DENSITY * spacing * spacing) {
                    measured.add(initial.withSpacing(spacing).withRays(rays));
                }
            }
        }
        BOUNCES.forEach(bounces -> measured.add(initial.withBounces(bounces)));
        return measured;
    }

    private void measureCost(NamedScene named, Progress progress) {
        PictureSize size = settings.quick() ? QUICK_COST_SIZE : COST_SIZE;
        Scene scene = size.of(named.scene());
        List<PaperCase> cases = ModernCases.of(scene);
        EditTurns with = EditTurns.of(scene, cases.stream().map(PaperCase::after).toList(), options, settings.repetitions(), true,
                progress);
        EditTurns without = EditTurns.of(scene.withoutIndirect(), cases.stream().map(edit -> edit.after().withoutIndirect()).toList(),
                options, settings.repetitions(), false, progress.cancellationOnly());
        List<IndirectCost.Edit> edits = new ArrayList<>();
        for (int i = 0; i < cases.size(); i++) {
            edits.add(new IndirectCost.Edit(cases.get(i).name(), cases.get(i).value(), TimeSamples.of(with.edits().get(i)),
                    TimeSamples.of(without.edits().get(i)), with.equal().get(i)));
            if (!with.equal().get(i)) {
                ledger.addBroken(named.name() + ", indirect light, " + cases.get(i).name(), "the image is not equal to a full trace");
            }
        }
        ledger.indirect().add(new IndirectCost(named.name(), size.width(), size.height(), scene.lights().size(),
                scene.picture().indirect().orElseThrow().label(), TimeSamples.of(with.first()), TimeSamples.of(without.first()),
                TimeSamples.of(requireNonNull(with.fullTrace())), (with.bytes() - without.bytes()) / (double) size.pixels(), with.points(),
                with.surfels(), edits));
    }

    private void measureAbsence(NamedScene named, Progress progress) {
        PictureSize size = settings.quick() ? QUICK_COST_SIZE : ABSENCE_SIZE;
        Scene scene = size.of(named.scene());
        HiddenEffectCost cost = HiddenEffectCost.of(scene.withoutIndirect(), scene, RenderEffect.INDIRECT, options,
                settings.isWarm() ? 3 * settings.repetitions() : 1, progress);
        if (!cost.equal()) {
            ledger.addBroken(named.name() + ", without indirect light",
                    "the image differs from that with hidden indirect light");
        }
        ledger.indirect().add(new IndirectAbsence(named.name(), size.width(), size.height(), cost.bytes() - cost.hiddenBytes(),
                cost.rays() - cost.hiddenRays(), cost.equal(), TimeSamples.of(cost.absent()), TimeSamples.of(cost.hidden())));
    }
}
