package lightning.cli;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.bench.accuracy.EffectCost;
import lightning.bench.accuracy.EffectCosts;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;
import lightning.scene.effects.Effects;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Tells which effects a scene calls for and what they take. */
@Command(name = "effects", header = "Tell what a scene calls for, with time and bytes.", abbreviateSynopsis = true,
        description = {
            "Derives from the scene alone which effects its picture needs, and measures what each takes: in milliseconds of the first",
            "pass, in milliseconds of the update after an edit, in bytes and in rays of the first pass. An effect in use is measured",
            "by rendering without it, one that is absent by forcing it on, where that leaves the picture as it is: these figures are",
            "what its absence saves. Finer samples, which are never invisible, are forced at edges. All are medians of turns with",
            "and without; a difference within the noise is marked with ~. Then come the bytes of each kind of column.",
            "",
            "The edit is one of the tour's, 'position' (a light is moved; 'direction' where none has a place) unless --case names another."},
        footer = {
            "Examples:",
            "  lightning effects scenes/bird.jen --size 1920x1080",
            "  lightning effects scenes/house.jen --case attenuation --repetitions 9"})
final class EffectsCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Mixin
    private PictureOptions picture;
    @Mixin
    private ThreadsOption threads;
    @Option(names = "--case", paramLabel = "NAME", description = "The edit, by its name in the tour.")
    private String edit;
    @Mixin
    private RepetitionsOption repetitions;

    EffectsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read().scene());
        Scene after = edited(scene);
        Options options = Options.DEFAULT.withThreads(threads.count());
        MemoryNeed.check(scene, options);
        try (Renderer renderer = new Renderer(options); ProgressBar bar = new ProgressBar(console, "effects")) {
            EffectCosts costs = EffectCosts.of(scene, after, options, repetitions.count(), bar);
            renderer.render(scene, bar.silent());
            bar.erase();
            print(Effects.of(scene), costs, renderer.cache());
        }
        return ExitCode.DONE;
    }

    /** The scene after the edit; the scene itself where none is named and it has no light to move. */
    private Scene edited(Scene scene) throws BadInput {
        if (edit == null) {
            return PaperCases.moved(scene).map(PaperCase::after).orElse(scene);
        }
        List<PaperCase> cases = PaperCases.of(scene);
        for (PaperCase one : cases) {
            if (one.name().equals(edit)) {
                return one.after();
            }
        }
        throw new BadInput("--case " + edit + ": expected one of "
                + String.join(", ", cases.stream().map(PaperCase::name).toList()) + ", which this scene allows");
    }

    private void print(Effects effects, EffectCosts costs, PixelCache cache) {
        console.line("first pass %.1f ms, %s; update %.2f ms: %s", costs.first().median(), Console.count(costs.bytes(), "byte"),
                costs.update().median(), costs.plan());
        console.line("");
        console.line("%-20s %10s %10s %12s %12s  %s", "in use", "first ms", "update ms", "bytes", "rays", "called for by");
        costs.effects().stream().filter(EffectCost::inUse).forEach(c -> line(c, effects.why(c.effect())));
        console.line("");
        console.line("%-20s %10s %10s %12s %12s", "absent, saves", "first ms", "update ms", "bytes", "rays");
        costs.effects().stream().filter(c -> !c.inUse()).forEach(c -> line(c, ""));
        console.line("");
        columns(ColumnBytes.of(cache), cache);
    }

    private void line(EffectCost cost, String callers) {
        if (!cost.measured()) {
            console.line("%-20s %10s %10s %12s %12s", cost.effect().title(), "-", "-", "-", "-");
            return;
        }
        String near = Math.abs(cost.firstMs()) <= cost.firstNoise() ? "~" : "";
        console.line("%-20s %10s %10.2f %12d %12d  %s", cost.effect().title(),
                near + String.format(Locale.ROOT, "%.1f", cost.firstMs()), cost.updateMs(), cost.bytes(), cost.rays().all(), callers);
    }

    private void columns(ColumnBytes bytes, PixelCache cache) {
        int depth = cache.all().stream().mapToInt(tile -> tile.levels.length - 1).max().orElse(0);
        console.line("%s; the deepest mirrored ray that any pixel needs is in mirror %d of %d", Console.count(bytes.rows(), "row"), depth,
                cache.scene().picture().depth());
        bytes.hits().forEach((part, n) -> column(title(part), n, bytes));
        column("mirror images", bytes.mirrored(), bytes);
        bytes.layers().forEach((title, n) -> column(title, n, bytes));
        column("in all", bytes.all(), bytes);
    }

    private static String title(HitRows.Part part) {
        return switch (part) {
            case HIT -> "point, normal, view, place";
            case TEXEL -> "texture colours";
            case CODE -> "what edges are told by";
            case OWNER -> "whose rows they are";
            case CLEAR -> "what is behind clear surfaces";
        };
    }

    private void column(String title, long bytes, ColumnBytes all) {
        console.line("  %-28s %12d bytes %8.2f a row", title, bytes, (double) bytes / Math.max(all.rows(), 1));
    }
}
