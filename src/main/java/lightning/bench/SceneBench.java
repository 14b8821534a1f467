package lightning.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.bench.accuracy.EffectCost;
import lightning.bench.accuracy.EffectCosts;
import lightning.bench.accuracy.Grade;
import lightning.bench.accuracy.Ladder;
import lightning.bench.accuracy.LadderMeter;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.bench.accuracy.Rung;
import lightning.bench.accuracy.SavingMeter;
import lightning.render.image.Film;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** Measures one scene at one size: its first pass, and the ladder of each edit with each value. */
final class SceneBench implements AutoCloseable {
    /** First passes for each repetition of an edit. */
    private static final int FIRST_PASSES = 3;
    /** Of each effect, with it and without. */
    private static final int EFFECTS = 2;

    private final Settings settings;
    private final Ledger ledger;
    private final Ledger.Page page;
    private final String name;
    private final Scene scene;
    private final double bytesPerMs;
    /** Null where no pictures are written. */
    private final Pictures pictures;
    private LadderMeter meter;

    SceneBench(Settings settings, Ledger ledger, Ledger.Page page, NamedScene named, PictureSize size, double bytesPerMs,
            Pictures pictures) {
        this.settings = settings;
        this.ledger = ledger;
        this.page = page;
        this.bytesPerMs = bytesPerMs;
        this.pictures = pictures;
        name = named.name();
        scene = size.of(named.scene());
    }

    /** What is to be measured. */
    List<Part> parts(Pace pace, PictureSize size) {
        String where = name + " at " + size;
        List<Part> parts = new ArrayList<>();
        parts.add(new Part(where + ", first pass", pace.firstPassMs(size, FIRST_PASSES * settings.repetitions()), this::firstPass));
        cases().forEach((edit, values) -> parts.add(new Part(where + ", " + edit,
                pace.ladderMs(size, settings.repetitions()) * values.size(), progress -> edit(values, progress))));
        if (settings.effects() && size.equals(settings.sizes().getLast())) {
            parts.add(new Part(where + ", effects",
                    pace.effectsMs(size, EFFECTS * settings.repetitions(), EffectCosts.measurable(scene)), this::effects));
        }
        return parts;
    }

    /** What each effect takes, in the first pass and in the update after a light was moved. */
    private void effects(Progress progress) {
        Scene after = PaperCases.moved(scene).map(PaperCase::after).orElse(scene);
        // The ladder's pictures need not lie in memory beside all the samples.
        close();
        EffectCosts costs = EffectCosts.of(scene, after, Options.DEFAULT.withThreads(settings.threads()),
                settings.isWarm() ? EFFECTS * settings.repetitions() : 1, progress);
        page.effects(costs.effects().stream().filter(EffectCost::measured).map(EffectResult::of).toList());
        costs.tooLarge().forEach(effect -> ledger.problem(new Failure(Failure.Kind.UNMEASURED,
                name + " at " + scene.picture().width() + "x" + scene.picture().height() + ", effects",
                "there is not enough memory for " + effect.title())));
    }

    /** The cases by name, with each value that changes the scene. */
    private Map<String, List<PaperCase>> cases() {
        Map<String, List<PaperCase>> cases = new LinkedHashMap<>();
        for (int value = 0; value < settings.values(); value++) {
            for (PaperCase edit : PaperCases.of(scene, value)) {
                if (settings.includes(edit)) {
                    cases.computeIfAbsent(edit.name(), _ -> new ArrayList<>()).add(edit);
                }
            }
        }
        // A value that says the same again is the same edit: a scene of depth 0 or 10 has fewer depths to change to.
        cases.values().forEach(values -> {
            List<String> seen = new ArrayList<>();
            values.removeIf(edit -> seen.contains(edit.value()) || !seen.add(edit.value()));
        });
        return cases;
    }

    private void firstPass(Progress progress) throws IOException {
        // The collector makes some of them slow; the median of a few would tell of it by chance.
        int times = FIRST_PASSES * settings.repetitions();
        try (SavingMeter first = new SavingMeter(Options.DEFAULT.withThreads(settings.threads()), times,
                settings.patienceMs(),
                bytesPerMs)) {
            page.firstPass(first.firstPass(scene, progress.silent()));
            if (pictures != null) {
                page.before(pictures.picture(name + "-before", first.renderer().film()));
            }
        }
    }

    private void edit(List<PaperCase> values, Progress progress) throws IOException {
        if (meter == null) {
            meter = new LadderMeter(settings.threads(), settings.repetitions(), settings.patienceMs());
        }
        List<ValueResult> results = new ArrayList<>();
        for (PaperCase edit : values) {
            List<Scene> scenes = edit.scenes();
            Ladder ladder = meter.measure(scenes.get(scenes.size() - 2), scenes.getLast(), progress.silent());
            results.add(new ValueResult(edit.value(), rungs(ladder, results.isEmpty() ? name + "-" + edit.name() : null)));
            progress.tiles(results.size(), values.size());
        }
        page.edit(EditResult.of(values.getFirst(), results));
    }

    /** @param picture how the names of its pictures begin, or null where none are written */
    private List<RungResult> rungs(Ladder ladder, String picture) throws IOException {
        Rung full = ladder.rung(Grade.FULL_TRACE);
        double fullMs = full.time().median();
        String reference = picture == null || pictures == null ? null : pictures.picture(picture + "-full", full.film());
        List<RungResult> results = new ArrayList<>();
        for (Rung rung : ladder.rungs()) {
            Work work = rung.update() == null ? null
                    : Work.of(rung.update(), rung.time().median(), fullMs, ladder.fullRays(), bytesPerMs);
            String grade = picture + "-" + rung.grade().name().toLowerCase(Locale.ROOT).replace('_', '-');
            results.add(new RungResult(rung.grade(), Samples.of(rung.time()), saving(rung, full), rung.error(), work,
                    reference == null ? null : shown(grade, rung.film(), full.film(), reference),
                    reference == null ? null : pictures.difference(grade + "-difference", rung.film(), full.film())));
        }
        return results;
    }

    private static double saving(Rung rung, Rung full) {
        return rung == full ? 0 : Samples.of(rung.time()).isApart(Samples.of(full.time())) ? rung.time().savingOf(full.time().median())
                : Double.NaN;
    }

    /** A picture equal to the reference needs no file of its own. */
    private String shown(String grade, Film film, Film full, String reference) throws IOException {
        return film.sameBits(full) ? reference : pictures.picture(grade, film);
    }

    @Override
    public void close() {
        if (meter != null) {
            meter.close();
            meter = null;
        }
    }
}
