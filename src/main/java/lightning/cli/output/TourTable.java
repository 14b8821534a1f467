package lightning.cli.output;

import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.PreviewCost;
import lightning.bench.accuracy.RivalTiming;
import lightning.bench.accuracy.UpdateSaving;

/** Table of the tour, printed line by line. */
public final class TourTable {
    private static final String COLUMNS = "%-15s %-40s %9s %11s %8s %8s %7s %6s %6s  %s";

    private static final String NOT_WARM = "not warm";

    private final Console console;
    private boolean hasColdTimes;

    public TourTable(Console console) {
        this.console = console;
    }

    public void printFirstPass(FirstPassCost cost, double bytesPerMs) {
        console.print(
                "first pass %.1f ms, full trace %.1f ms: caching costs %.1f %%%s (the paper: 19; writing it to memory at %.0f GB/s"
                        + " alone: %.1f)",
                cost.first().median(), cost.full().median(), cost.percentSlower(),
                cost.isWarm() ? "" : " (" + NOT_WARM + ")", bytesPerMs / 1e6,
                cost.percentAtMemoryLimit());
        console.print("cached: %s, %.1f bytes per row", Console.count(cost.rows(), "row"), cost.bytesPerRow());
        console.print("");
    }

    public void printPovRay(RivalTiming times) {
        console.print("POV-Ray traces the exported scene in %.0f ms, the full trace takes %.1f ms: %.2f times as fast",
                times.rival().median(),
                times.full().median(), times.ratio());
        console.print("");
    }

    public void printPreview(PreviewCost cost) {
        console.print("preview at 600 x 600 pixels: a moved light %.1f ms, a moved camera %.1f ms", cost.lightMs(), cost.cameraMs());
        console.print("");
    }

    public void printHeader() {
        console.print(COLUMNS, "edit", "plan", "rows", "shadow rays", "ms", "full ms", "saves %", "paper", "cap", "equal");
    }

    /**
     * Prints one edit.
     *
     * @param paper percent saved in the paper, NaN if not reported
     */
    public void printRow(String name, double paper, UpdateSaving saving) {
        console.print(COLUMNS, name, saving.update().plan().description(), saving.update().rowsTouched(),
                saving.update().rays().shadow(), BenchTable.number(saving.time().median(), 2), BenchTable.number(saving.full().median(), 1),
                BenchTable.number(saving.percent(), 1),
                BenchTable.number(paper, 0), BenchTable.number(saving.maxPercent(), 1),
                (saving.isVerified() ? "yes" : "NO") + (saving.isWarm() ? "" : ", " + NOT_WARM));
        hasColdTimes |= !saving.isWarm();
    }

    public void printFooter() {
        console.print("");
        console.print("saves: share of a full trace's time; paper: on its own scene and machine of 1998;"
                + " cap: upper bound by ray counts and memory");
        if (hasColdTimes) {
            console.print("not warm: Java was still compiling; these times and savings are not reliable");
        }
    }
}
