package lightning.cli.output;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.bench.result.BenchResults;
import lightning.bench.result.DriftPoint;
import lightning.bench.result.EditResult;
import lightning.bench.result.EditingCost;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.FirstPassResult;
import lightning.bench.result.IndirectAccuracy;
import lightning.bench.result.IndirectCost;
import lightning.bench.result.IndirectGrowth;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.ModernPicture;
import lightning.bench.result.ModernScene;
import lightning.bench.result.RayThroughput;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SoftShadowAccuracy;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.SystemLoad;
import lightning.render.measure.AccuracySetting;
import org.jspecify.annotations.Nullable;

/** Table of a benchmark, printed while the benchmark runs. */
public final class BenchTable {
    private static final String COLUMNS = "%-15s %8s %7s %6s %6s | %8s %8s %8s %8s %8s %8s | %6s %6s";

    /** Accuracy settings with a column of milliseconds after the full trace's. */
    private static final Set<AccuracySetting> TIMED_SETTINGS =
            EnumSet.complementOf(EnumSet.of(AccuracySetting.FULL_TRACE, AccuracySetting.FEW_SAMPLES, AccuracySetting.NO_ANTIALIASING));

    private final Console console;
    /** Number of edits already printed, by scene and size. */
    private final Map<String, Integer> printedEdits = new HashMap<>();

    public BenchTable(Console console) {
        this.console = console;
    }

    /** Prints the rows that were not printed yet. */
    public void printNew(BenchResults results) {
        for (SceneResult scene : results.scenes()) {
            String name = Console.text("%s at %d x %d", scene.scene(), scene.width(), scene.height());
            int printedCount = printedEdits.getOrDefault(name, 0);
            if (printedCount == 0 && !scene.edits().isEmpty()) {
                printHeader(name, scene);
            }
            scene.edits().stream().skip(printedCount).forEach(this::printRow);
            printedEdits.put(name, scene.edits().size());
        }
    }

    private void printHeader(String name, SceneResult scene) {
        console.print("");
        console.print("%s, depth %d, %s, %s%s", name, scene.depth(), Console.count(scene.shapes(), "object"),
                Console.count(scene.lights(), "light"),
                firstPass(scene.firstPass()));
        console.print(COLUMNS, "edit", "full ms", "saves %", "paper", "cap", "half", "fast", "ratio", "exact", "updated", "current",
                "half", "fast");
    }

    private static String firstPass(@Nullable FirstPassResult first) {
        return first == null ? "" : Console.text(": first pass %.1f ms, %+.1f %%; %.1f bytes a pixel", first.time().median(),
                first.percentSlower(), first.bytesPerPixel());
    }

    private void printRow(EditResult edit) {
        Stream<String> first = Stream.of(edit.edit(), ms(edit, AccuracySetting.FULL_TRACE), number(edit.saving(), 1),
                number(edit.paperSaving(), 0), number(edit.cap(), 1));
        Stream<String> errors = Stream.of(flip(edit, AccuracySetting.HALF_RESOLUTION), flip(edit, AccuracySetting.FAST_SHADING));
        console.print(COLUMNS,
                Stream.of(first, TIMED_SETTINGS.stream().map(grade -> ms(edit, grade)), errors).flatMap(cells -> cells).toArray());
    }

    private static String flip(EditResult edit, AccuracySetting grade) {
        return number(average(edit, rung -> rung.error().flip(), grade), 3);
    }

    /** Returns the mean over all values of the median times, in milliseconds. */
    private static String ms(EditResult edit, AccuracySetting grade) {
        return number(average(edit, rung -> rung.time().median(), grade), 2);
    }

    private static double average(EditResult edit, ToDoubleFunction<SweepPointResult> what, AccuracySetting grade) {
        return edit.values().stream().mapToDouble(value -> what.applyAsDouble(value.point(grade))).average()
                .orElse(Double.NaN);
    }

    /** Formats a number; empty if it is not a number. */
    static String number(double value, int digits) {
        return Double.isNaN(value) ? "" : Console.text("%." + digits + "f", value);
    }

    /** Prints the legend of the columns, and the results outside the table. */
    public void printSummary(BenchResults results) {
        console.print("");
        console.print("saves: at accuracy " + AccuracySetting.DEFAULT.label()
                + " (default), share of a full trace's time; paper: on its own scene and machine of 1998;");
        console.print("cap: upper bound by ray counts and memory; then milliseconds at each accuracy, and the mean FLIP error (0 to 1) of"
                + " the two coarsest");
        for (SceneResult scene : results.scenes()) {
            if (scene.peer() != null) {
                console.print("%s at %d x %d: %.1f times as fast as %s; %.2f %% of the pixels show the same object", scene.scene(),
                        scene.width(),
                        scene.height(), scene.peer().ratio(), scene.peer().program(), 100 * scene.peer().agreement());
            }
        }
        for (SceneResult scene : results.scenes()) {
            if (scene.cold() != null) {
                console.print("%s at %d x %d, cold start: %.2f s%s", scene.scene(), scene.width(), scene.height(),
                        scene.cold().process().median() / 1e3, scene.cold().rival() == null ? ""
                                : Console.text(", %s %.2f s", scene.cold().rival().program(),
                                        scene.cold().rival().process().median() / 1e3));
            }
        }
        results.modern().forEach(this::printModern);
        results.indirect().accuracy().forEach(this::printIndirectErrors);
        results.indirect().reflections().forEach(this::printReflections);
        results.indirect().softShadows().forEach(this::printSoftShadows);
        results.indirect().costs().forEach(this::printIndirectCost);
        results.indirect().growth().forEach(this::printIndirectGrowth);
        results.editing().forEach(e -> console.print("%s", editing(e)));
        results.meshes().forEach(m -> m.rays().forEach(pace -> console.print("%s", mesh(m, pace))));
        results.drift().forEach(drift -> drift.points().stream().reduce((_, last) -> last).ifPresent(last -> drift.points().stream()
                .filter(point -> point.edits() == last.edits()).forEach(point -> console.print("%s", drift(point)))));
        results.problems().forEach(problem -> console.print("PROBLEM %s: %s", problem.where(), problem.what()));
        SystemLoad load = results.run().load();
        if (load.isBusy(results.run().machine().processors())) {
            console.print("THIS MACHINE WAS BUSY: load average %.2f before, %.2f now; other processes used %.0f %% of the processor time",
                    load.atStart(), load.atEnd(), 100 * load.others());
        }
        console.print("memory: %.0f GB/s; took %.0f s, predicted %.0f s", results.run().triadGBs(), results.run().actualSeconds(),
                results.run().predictedSeconds());
    }

    private void printModern(ModernScene scene) {
        for (ModernPicture p : scene.pictures()) {
            if (p.firstPass() != null) {
                console.print("%s at %d x %d, anti-aliasing %s: full trace %.1f ms, first pass %+.1f %%; saves %s", scene.scene(),
                        p.width(),
                        p.height(), p.sampling().label(), p.firstPass().fullTrace().median(), p.firstPass().percentSlower(),
                        p.edits().stream().map(edit -> Console.text("%s %s %%", edit.edit(), number(edit.saving(), 1)))
                                .collect(Collectors.joining(", ")));
            }
            if (p.cold() != null) {
                console.print("%s at %d x %d, anti-aliasing %s, cold start: %.2f s%s", scene.scene(), p.coldWidth(), p.coldHeight(),
                        p.sampling().label(), p.cold().process().median() / 1e3, p.cold().rival() == null ? ""
                                : Console.text(", %s %.2f s", p.cold().rival().program(), p.cold().rival().process().median() / 1e3));
            }
        }
        for (ErrorCurve curve : scene.curves()) {
            console.print("%s at %d x %d, %s: %s", scene.scene(), curve.width(), curve.height(), curve.program(),
                    curve.points().stream().map(point -> Console.text("%s %.1f ms, error %.4f", point.setting(), point.time().median(),
                            point.error())).collect(Collectors.joining("; ")));
        }
    }

    private void printIndirectErrors(IndirectAccuracy scene) {
        console.print("%s at %d x %d, indirect light, %s: %s", scene.scene(), scene.width(), scene.height(),
                Console.count(scene.pixels(), "pixel"), scene.points().stream().map(p -> Console.text(
                        "spacing %d, rays %d, bounces %d: %.1f ms, mean error %.1f %%", p.spacing(), p.rays(), p.bounces(),
                        p.time().median(), 100 * p.error().mean())).collect(Collectors.joining("; ")));
    }

    private void printReflections(ReflectionAccuracy scene) {
        console.print("%s at %d x %d, blurred reflections, %s: %s", scene.scene(), scene.width(), scene.height(),
                Console.count(scene.pixels(), "pixel"), scene.points().stream().map(p -> Console.text(
                        "%d rays: %.1f ms, mean error %.1f %%, of the pixels' colors %.1f %%, bias %.1f %%", p.rays(), p.time().median(),
                        100 * p.mean(),
                        100 * p.shown(), 100 * p.bias())).collect(Collectors.joining("; ")));
    }

    private void printSoftShadows(SoftShadowAccuracy scene) {
        console.print("%s at %d x %d, %s: %s", scene.scene(), scene.width(), scene.height(), Console.count(scene.lights(), "area light"),
                scene.points().stream().map(p -> Console.text("%d samples: %.1f ms, mean error %.1f %%", p.samples(), p.time().median(),
                        100 * p.mean())).collect(Collectors.joining("; ")));
    }

    private void printIndirectCost(IndirectCost scene) {
        console.print("%s at %d x %d, indirect light: first pass %.0f ms, %.0f ms without, %.1f bytes a pixel; %s", scene.scene(),
                scene.width(), scene.height(), scene.first().median(), scene.without().median(), scene.bytesPerPixel(),
                scene.edits().stream().map(e -> Console.text("%s %.1f ms, %.1f ms without", e.edit(), e.time().median(),
                        e.without().median())).collect(Collectors.joining("; ")));
    }

    private void printIndirectGrowth(IndirectGrowth growth) {
        console.print("growth of indirect light with %s: %s", growth.along(), growth.points().stream().map(p -> Console.text(
                "%d: first pass +%.1f ms, moved light %.1f ms, intensity %.1f ms", p.at(), p.extraMs(), p.position().median(),
                p.intensity().median())).collect(Collectors.joining("; ")));
    }

    private static String editing(EditingCost e) {
        return Console.text("%s, %s: load %.0f ms, BVH %.0f ms, new scene %.3f ms, plan %.3f ms, first hover %.2f ms%s",
                Console.count(e.shapes(), "object"), Console.count(e.lights(), "light"), e.load().median(), e.tree().median(),
                e.newScene().median(), e.plan().median(),
                e.hover().median(), Double.isNaN(e.documentBytes()) ? ""
                        : Console.text("; %.0f + %.0f bytes per object", e.documentBytes(), e.treeBytes()));
    }

    private static String mesh(MeshPoint m, RayThroughput rays) {
        return Console.text("%s, %s rays: %.2f million per second%s; BVH %.0f ms%s, %.1f bytes per triangle",
                Console.count(m.triangles(), "triangle"),
                rays.rays(),
                rays.millionsPerSecond(), rays.rival() == null ? "" : Console.text(", %.0f %% of Embree", rays.share()), m.tree().median(),
                m.rival() == null ? "" : Console.text(", Embree %.0f ms", m.rival().tree().median()), m.treeBytes());
    }

    private static String drift(DriftPoint point) {
        return Console.text("after %s, accuracy %s: %s, by at most %.2g (limit %.2g)", Console.count(point.edits(), "edit"),
                point.setting(),
                (point.error().values() == 1 ? "1 value differs" : point.error().values() + " values differ"), point.error().maxAbsolute(),
                point.bound());
    }
}
