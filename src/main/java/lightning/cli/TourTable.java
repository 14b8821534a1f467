package lightning.cli;

import lightning.bench.accuracy.FirstPassCost;
import lightning.bench.accuracy.PreviewCost;
import lightning.bench.accuracy.Saving;
import lightning.bench.accuracy.TurnTimes;

/** The tour's table, one line at a time. */
final class TourTable {
    private static final String COLUMNS = "%-15s %-40s %9s %11s %8s %8s %7s %6s %6s  %s";

    private static final String NOT_WARM = "not warm";

    private final Console console;
    private boolean cold;

    TourTable(Console console) {
        this.console = console;
    }

    void first(FirstPassCost cost, double bytesPerMs) {
        console.line("first pass %.1f ms, full trace %.1f ms: keeping all costs %.1f %%%s (the paper: 19; writing it to memory at %.0f GB/s"
                + " alone: %.1f)", cost.first().median(), cost.full().median(), cost.percentSlower(),
                cost.warm() ? "" : " (" + NOT_WARM + ")", bytesPerMs / 1e6,
                cost.percentFloor());
        console.line("kept: %s, %.1f bytes a row", Console.count(cost.rows(), "row"), cost.bytesPerRow());
        console.line("");
    }

    void povRay(TurnTimes times) {
        console.line("POV-Ray traces the exported scene in %.0f ms, the full trace takes %.1f ms: %.2f times as fast",
                times.rival().median(),
                times.full().median(), times.ratio());
        console.line("");
    }

    void preview(PreviewCost cost) {
        console.line("preview of 600 x 600 pixels: a moved light %.1f ms, a moved camera %.1f ms", cost.lightMs(), cost.cameraMs());
        console.line("");
    }

    void head() {
        console.line(COLUMNS, "edit", "plan", "rows", "shadow rays", "ms", "full ms", "saves %", "paper", "cap", "equal");
    }

    /** @param paper percent that the paper saved, NaN where it says nothing */
    void row(String name, double paper, Saving saving) {
        console.line(COLUMNS, name, saving.update().plan().text(), saving.update().rowsTouched(),
                saving.update().rays().shadow(), number(saving.time().median(), 2), number(saving.full().median(), 1),
                number(saving.percent(), 1),
                number(paper, 0), number(saving.cap(), 1), (saving.kept() ? "yes" : "NO") + (saving.warm() ? "" : ", " + NOT_WARM));
        cold |= !saving.warm();
    }

    void foot() {
        console.line("");
        console.line("saves: of a full trace's time; paper: on its own scene and machine of 1998; cap: what ray counts and memory allow");
        if (cold) {
            console.line("not warm: Java still compiled what was timed; these times, and what they save, say little");
        }
    }

    private static String number(double value, int digits) {
        return Double.isNaN(value) ? "" : Console.text("%." + digits + "f", value);
    }
}
