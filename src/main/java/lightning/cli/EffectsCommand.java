package lightning.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.RepetitionsOption;
import lightning.cli.option.ThreadsOption;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.cli.output.ProgressBar;
import lightning.cli.report.EffectsReport;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.measure.EffectCost;
import lightning.render.measure.EffectCosts;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.Renderer;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;
import lightning.scene.effects.SceneEffects;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Measures which effects a scene uses and the cost of each. */
@Command(name = "effects", header = "Measure the cost of each effect.", abbreviateSynopsis = true,
        description = {
            "Determines from the scene which effects its image needs, and measures the cost of each: milliseconds of the first pass "
                    + "and of the update after an edit, bytes, and rays of the first pass. Then prints the bytes of each kind of column.",
            "",
            "Effects in use are measured by rendering without them. Unused effects are measured by forcing them on if that does not "
                    + "change the image; the figures show what their absence saves. Anti-aliasing is forced at edges only, since it always "
                    + "changes the image. All figures are medians of alternating runs; ~ marks a difference within the noise."},
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
    @Option(names = "--case", paramLabel = "NAME",
            description = "Edit to measure, by its name in 'lightning tour' (default: position, or direction if no light has a position).")
    private @Nullable String caseName;
    @Mixin
    private RepetitionsOption repetitions;

    EffectsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read(console).scene());
        Scene after = edited(scene);
        RenderOptions options = RenderOptions.DEFAULT.withThreads(threads.count());
        MemoryEstimate.check(scene, options);
        try (Renderer renderer = new Renderer(options); ProgressBar bar = new ProgressBar(console, "effects")) {
            EffectCosts costs = EffectCosts.of(scene, after, options, repetitions.count(), bar);
            renderer.render(scene, bar.cancellationOnly());
            print(SceneEffects.of(scene), costs, renderer.cache());
            console.report().setResult(report(costs, renderer.cache()));
        }
        return ExitCode.OK;
    }

    /** Returns the scene after the edit, or the unchanged scene if no edit is named and no light can be moved. */
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
                + String.join(", ", cases.stream().map(PaperCase::name).toList()) + ", the cases of this scene");
    }

    private void print(SceneEffects effects, EffectCosts costs, PixelCache cache) {
        console.print("first pass %.1f ms, %s; update %.2f ms: %s", costs.first().median(), Console.count(costs.bytes(), "byte"),
                costs.update().median(), costs.plan());
        console.print("");
        console.print("%-20s %10s %10s %12s %12s  %s", "in use", "first ms", "update ms", "bytes", "rays", "used by");
        costs.effects().stream().filter(EffectCost::inUse).forEach(c -> printCost(c, effects.reason(c.effect())));
        console.print("");
        console.print("%-20s %10s %10s %12s %12s", "not used, saves", "first ms", "update ms", "bytes", "rays");
        costs.effects().stream().filter(c -> !c.inUse()).forEach(c -> printCost(c, ""));
        console.print("");
        printColumns(ColumnBytes.of(cache), cache);
    }

    private static EffectsReport report(EffectCosts costs, PixelCache cache) {
        ColumnBytes bytes = ColumnBytes.of(cache);
        List<EffectsReport.Column> columns = new ArrayList<>();
        bytes.hitColumns().forEach((part, n) -> columns.add(new EffectsReport.Column(title(part), n)));
        columns.add(new EffectsReport.Column("reflected images", bytes.mirrorBytes()));
        bytes.layerColumns().forEach((title, n) -> columns.add(new EffectsReport.Column(title, n)));
        bytes.indirectBytes().forEach((title, n) -> columns.add(new EffectsReport.Column(title, n)));
        return new EffectsReport(costs.first().median(), costs.update().median(), costs.plan(), costs.bytes(), bytes.rowCount(),
                costs.effects().stream().map(EffectsCommand::report).toList(), columns);
    }

    private static EffectsReport.Effect report(EffectCost cost) {
        return cost.measured()
                ? new EffectsReport.Effect(cost.effect().title(), cost.inUse(), cost.callers(), true, cost.firstMs(), cost.firstNoise(),
                        cost.updateMs(), cost.bytes(), cost.rays().total())
                : new EffectsReport.Effect(cost.effect().title(), cost.inUse(), cost.callers(), false, null, null, null, null, null);
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
        int depth = cache.allTiles().stream().mapToInt(tile -> tile.levels().length - 1).max().orElse(0);
        console.print("%s; deepest reflection that any pixel needs: bounce %d of %d", Console.count(bytes.rowCount(), "row"),
                depth,
                cache.scene().picture().depth());
        bytes.hitColumns().forEach((part, n) -> printColumn(title(part), n, bytes));
        printColumn("reflected images", bytes.mirrorBytes(), bytes);
        bytes.layerColumns().forEach((title, n) -> printColumn(title, n, bytes));
        bytes.indirectBytes().forEach((title, n) -> printColumn(title, n, bytes));
        printColumn("total", bytes.total(), bytes);
    }

    private static String title(HitRows.ColumnGroup part) {
        return switch (part) {
            case HIT -> "point, normal, view, position";
            case TEXEL -> "texture colors";
            case TANGENT -> "tangents";
            case PATTERN -> "anti-aliasing";
            case OWNER -> "shape of each row";
            case TRANSPARENT -> "seen through transparent surfaces";
            case ROUGHNESS_TEXEL, METALNESS_TEXEL -> "values of " + part.map().orElseThrow().title() + "s";
            default -> "colors of " + part.map().orElseThrow().title() + "s";
        };
    }

    private void printColumn(String title, long bytes, ColumnBytes columns) {
        console.print("  %-28s %12d bytes %8.2f per row", title, bytes, (double) bytes / Math.max(columns.rowCount(), 1));
    }
}
