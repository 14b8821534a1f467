package lightning.cli;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.bench.accuracy.EffectCost;
import lightning.bench.accuracy.EffectCosts;
import lightning.bench.accuracy.PaperCase;
import lightning.bench.accuracy.PaperCases;
import lightning.render.cache.PixelCache;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;
import lightning.scene.effects.SceneEffects;
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
    private String caseName;
    @Mixin
    private RepetitionsOption repetitions;

    EffectsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read().scene());
        Scene after = edited(scene);
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count());
        MemoryEstimate.check(scene, options);
        try (Renderer renderer = new Renderer(options); ProgressBar bar = new ProgressBar(console, "effects")) {
            EffectCosts costs = EffectCosts.of(scene, after, options, repetitions.count(), bar);
            renderer.render(scene, bar.cancellationOnly());
            bar.erase();
            print(SceneEffects.of(scene), costs, renderer.cache());
        }
        return ExitCode.OK;
    }

    /** The scene after the edit; the scene itself where none is named and it has no light to move. */
    private Scene edited(Scene scene) throws BadInputException {
        if (caseName == null) {
            return PaperCases.moveCase(scene).map(PaperCase::after).orElse(scene);
        }
        List<PaperCase> cases = PaperCases.of(scene);
        for (PaperCase candidate : cases) {
            if (candidate.name().equals(caseName)) {
                return candidate.after();
            }
        }
        throw new BadInputException("--case " + caseName + ": expected one of "
                + String.join(", ", cases.stream().map(PaperCase::name).toList()) + ", which this scene allows");
    }

    private void print(SceneEffects effects, EffectCosts costs, PixelCache cache) {
        console.print("first pass %.1f ms, %s; update %.2f ms: %s", costs.first().median(), Console.count(costs.bytes(), "byte"),
                costs.update().median(), costs.plan());
        console.print("");
        console.print("%-20s %10s %10s %12s %12s  %s", "in use", "first ms", "update ms", "bytes", "rays", "called for by");
        costs.effects().stream().filter(EffectCost::inUse).forEach(c -> printCost(c, effects.reason(c.effect())));
        console.print("");
        console.print("%-20s %10s %10s %12s %12s", "absent, saves", "first ms", "update ms", "bytes", "rays");
        costs.effects().stream().filter(c -> !c.inUse()).forEach(c -> printCost(c, ""));
        console.print("");
        printColumns(ColumnBytes.of(cache), cache);
    }

    private void printCost(EffectCost cost, String callers) {
        if (!cost.measured()) {
            console.print("%-20s %10s %10s %12s %12s", cost.effect().title(), "-", "-", "-", "-");
            return;
        }
        String noiseMark = Math.abs(cost.firstMs()) <= cost.firstNoise() ? "~" : "";
        console.print("%-20s %10s %10.2f %12d %12d  %s", cost.effect().title(),
                noiseMark + String.format(Locale.ROOT, "%.1f", cost.firstMs()), cost.updateMs(), cost.bytes(), cost.rays().total(),
                callers);
    }

    private void printColumns(ColumnBytes bytes, PixelCache cache) {
        int depth = cache.allTiles().stream().mapToInt(tile -> tile.levels.length - 1).max().orElse(0);
        console.print("%s; the deepest mirrored ray that any pixel needs is in mirror %d of %d", Console.count(bytes.rowCount(), "row"),
                depth,
                cache.scene().picture().depth());
        bytes.hitColumns().forEach((part, n) -> printColumn(title(part), n, bytes));
        printColumn("mirror images", bytes.mirrorBytes(), bytes);
        bytes.layerColumns().forEach((title, n) -> printColumn(title, n, bytes));
        printColumn("in all", bytes.total(), bytes);
    }

    private static String title(HitRows.ColumnGroup part) {
        return switch (part) {
            case HIT -> "point, normal, view, place";
            case TEXEL -> "texture colors";
            case CODE -> "what edges are told by";
            case OWNER -> "whose rows they are";
            case TRANSPARENT -> "what is behind clear surfaces";
        };
    }

    private void printColumn(String title, long bytes, ColumnBytes columns) {
        console.print("  %-28s %12d bytes %8.2f a row", title, bytes, (double) bytes / Math.max(columns.rowCount(), 1));
    }
}
