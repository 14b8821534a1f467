package lightning.bench;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.bench.result.EditResult;
import lightning.bench.result.EffectResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.TimeSamples;
import lightning.bench.result.UpdateWork;
import lightning.bench.result.ValueResult;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.AccuracySweep;
import lightning.render.measure.AccuracySweepMeter;
import lightning.render.measure.EffectCost;
import lightning.render.measure.EffectCosts;
import lightning.render.measure.SweepPoint;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;

/** Benchmark of one scene at one size: its first pass, and all accuracy settings for each edit and value. */
final class SceneBench implements AutoCloseable {
    /** Number of first passes per repetition of an edit. */
    private static final int FIRST_PASSES = 3;
    /** Number of passes per effect: with and without it. */
    private static final int EFFECT_PASSES = 2;

    private final BenchSettings settings;
    private final ResultCollector ledger;
    private final ResultCollector.SceneCollector collector;
    private final String name;
    private final Scene scene;
    private final double bytesPerMs;
    /** Image writer; null if no images are written. */
    private final @Nullable PictureWriter pictures;
    private @Nullable AccuracySweepMeter meter;

    SceneBench(BenchSettings settings, ResultCollector ledger, ResultCollector.SceneCollector collector, NamedScene namedScene,
            PictureSize size, double bytesPerMs, @Nullable PictureWriter pictures) {
        this.settings = settings;
        this.ledger = ledger;
        this.collector = collector;
        this.bytesPerMs = bytesPerMs;
        this.pictures = pictures;
        name = namedScene.name();
        scene = size.of(namedScene.scene());
    }

    /** Returns the parts to measure. */
    List<BenchPart> parts(TraceThroughput throughput, PictureSize size) {
        String title = name + " at " + size;
        List<BenchPart> parts = new ArrayList<>();
        parts.add(new BenchPart(title + ", first pass", throughput.firstPassMs(size, FIRST_PASSES * settings.repetitions()),
                this::measureFirstPass));
        cases().forEach((edit, values) -> parts.add(new BenchPart(title + ", " + edit,
                throughput.sweepMs(size, settings.repetitions()) * values.size(), progress -> measureEdit(values, progress))));
        if (settings.effects() && size.equals(settings.sizes().getLast())) {
            parts.add(new BenchPart(title + ", effects",
                    throughput.effectsMs(size, EFFECT_PASSES * settings.repetitions(), EffectCosts.measurableCount(scene)),
                    this::measureEffects));
        }
        return parts;
    }

    /** Measures the cost of each effect in the first pass and in the update after moving a light. */
    private void measureEffects(Progress progress) {
        Scene after = PaperCases.moveCase(scene).map(PaperCase::after).orElse(scene);
        // Frees the images of the sweep before all samples are in memory.
        close();
        EffectCosts costs = EffectCosts.of(scene, after, RenderOptions.DEFAULT.withThreads(settings.threads()),
                settings.isWarm() ? EFFECT_PASSES * settings.repetitions() : 1, progress);
        collector.setEffects(costs.effects().stream().filter(EffectCost::measured).map(EffectResult::of).toList());
        String where = name + " at " + scene.picture().width() + "x" + scene.picture().height() + ", effects";
        costs.effectsOverMemory().forEach(effect -> ledger.addUnmeasured(where, "not enough memory for " + effect.title()));
    }

    /** Returns the cases by name, with each value that changes the scene. */
    private Map<String, List<PaperCase>> cases() {
        Map<String, List<PaperCase>> cases = new LinkedHashMap<>();
        for (int value = 0; value < settings.values(); value++) {
            for (PaperCase edit : PaperCases.of(scene, value)) {
                if (settings.includes(edit)) {
                    cases.computeIfAbsent(edit.name(), _ -> new ArrayList<>()).add(edit);
                }
            }
        }
        // Skips duplicate values: a scene of depth 0 or 10 has fewer other depths.
        cases.values().forEach(values -> {
            List<String> seenValues = new ArrayList<>();
            values.removeIf(edit -> seenValues.contains(edit.value()) || !seenValues.add(edit.value()));
        });
        return cases;
    }

    private void measureFirstPass(Progress progress) throws IOException {
        // Garbage collection slows some of them; a median of few samples would depend on chance.
        int passes = FIRST_PASSES * settings.repetitions();
        try (UpdateSavingMeter meter = new UpdateSavingMeter(RenderOptions.DEFAULT.withThreads(settings.threads()), passes,
                settings.patienceMs(),
                bytesPerMs)) {
            collector.setFirstPass(meter.firstPass(scene, progress.cancellationOnly()));
            if (pictures != null) {
                collector.setPictureBefore(pictures.writePicture(name + "-before", meter.renderer().film()));
            }
        }
    }

    private void measureEdit(List<PaperCase> values, Progress progress) throws IOException {
        if (meter == null) {
            meter = new AccuracySweepMeter(settings.threads(), settings.repetitions(), settings.patienceMs());
        }
        List<ValueResult> results = new ArrayList<>();
        for (PaperCase edit : values) {
            List<Scene> scenes = edit.scenes();
            AccuracySweep sweep = meter.measure(scenes.get(scenes.size() - 2), scenes.getLast(), progress.cancellationOnly());
            results.add(new ValueResult(edit.value(), results(sweep, results.isEmpty() ? name + "-" + edit.name() : null)));
            progress.report(results.size(), values.size());
        }
        collector.addEdit(EditResult.of(values.getFirst(), results));
    }

    /** @param namePrefix prefix of the image names; null if none are written */
    private List<SweepPointResult> results(AccuracySweep sweep, @Nullable String namePrefix) throws IOException {
        SweepPoint full = sweep.point(AccuracySetting.FULL_TRACE);
        double fullMs = full.time().median();
        String reference = namePrefix == null || pictures == null ? null : pictures.writePicture(namePrefix + "-full", full.film());
        List<SweepPointResult> results = new ArrayList<>();
        for (SweepPoint point : sweep.points()) {
            UpdateWork work = point.update() == null ? null
                    : UpdateWork.of(point.update(), point.time().median(), fullMs, sweep.fullRays(), bytesPerMs);
            String pictureName = namePrefix + "-" + point.setting().name().toLowerCase(Locale.ROOT).replace('_', '-');
            results.add(new SweepPointResult(point.setting(), TimeSamples.of(point.time()), saving(point, full), point.error(), work,
                    reference == null ? null : pictureFile(pictureName, point.film(), full.film(), reference),
                    reference == null || pictures == null ? null
                            : pictures.writeDifference(pictureName + "-difference", point.film(), full.film())));
        }
        return results;
    }

    private static double saving(SweepPoint point, SweepPoint full) {
        return point == full ? 0
                : TimeSamples.of(point.time()).isDistinctFrom(TimeSamples.of(full.time()))
                        ? point.time().percentSavedOf(full.time().median())
                : Double.NaN;
    }

    /** Returns the file of an image; images equal to the reference share its file. */
    private String pictureFile(String pictureName, Film film, Film full, String reference) throws IOException {
        return film.hasSameBits(full) ? reference : requireNonNull(pictures).writePicture(pictureName, film);
    }

    @Override
    public void close() {
        if (meter != null) {
            meter.close();
            meter = null;
        }
    }
}
