package lightning.editor.document;

import com.github.difflib.algorithm.Change;
import com.github.difflib.algorithm.myers.MyersDiffWithLinearSpace;
import java.util.ArrayList;
import java.util.List;

/** Two texts line by line, side by side: lines that both have stand in one row. */
public final class TextDifference {
    /** The product of the numbers of lines that are compared at most. What differs more is told as all different. */
    private static final long MOST_PAIRS = 16L << 20;

    private TextDifference() {}

    /**
     * A row.
     *
     * @param mineLine   the line's number in the first text, from 1; 0 where it has none
     * @param mine       the line without its end; empty where there is none
     * @param theirsLine the same of the second text
     */
    public record Row(int mineLine, String mine, int theirsLine, String theirs) {
        /** Whether both texts have the line. */
        public boolean isSame() {
            return mineLine > 0 && theirsLine > 0 && mine.equals(theirs);
        }
    }

    /** All lines of both texts, in their order; the fewest rows are not the same, where that can be found out in reason. */
    public static List<Row> rows(String mine, String theirs) {
        List<String> a = mine.lines().toList();
        List<String> b = theirs.lines().toList();
        int head = 0;
        while (head < Math.min(a.size(), b.size()) && a.get(head).equals(b.get(head))) {
            head++;
        }
        int tail = 0;
        while (tail < Math.min(a.size(), b.size()) - head && a.get(a.size() - 1 - tail).equals(b.get(b.size() - 1 - tail))) {
            tail++;
        }
        List<String> middleA = a.subList(head, a.size() - tail);
        List<String> middleB = b.subList(head, b.size() - tail);
        var rows = new Rows(a, b);
        rows.add(head, head);
        if ((long) middleA.size() * middleB.size() > MOST_PAIRS) {
            rows.add(middleA.size(), middleB.size());
        } else {
            // Neighboring changes are one: the algorithm may split a changed block into single lines that are deleted and inserted.
            int onlyA = 0;
            int onlyB = 0;
            int end = 0;
            for (Change change : new MyersDiffWithLinearSpace<String>().computeDiff(middleA, middleB, null)) {
                if (change.startOriginal > end) {
                    rows.add(onlyA, onlyB);
                    rows.add(change.startOriginal - end, change.startOriginal - end);
                    onlyA = 0;
                    onlyB = 0;
                }
                onlyA += change.endOriginal - change.startOriginal;
                onlyB += change.endRevised - change.startRevised;
                end = change.endOriginal;
            }
            rows.add(onlyA, onlyB);
            rows.add(middleA.size() - end, middleA.size() - end);
        }
        rows.add(tail, tail);
        return rows.all;
    }

    /** Rows so far, and how many lines of each text they hold. */
    private static final class Rows {
        private final List<Row> all = new ArrayList<>();
        private final List<String> mine;
        private final List<String> theirs;
        private int mineDone;
        private int theirsDone;

        Rows(List<String> mine, List<String> theirs) {
            this.mine = mine;
            this.theirs = theirs;
        }

        /** Adds lines of both texts side by side as far as there are some on both sides. */
        void add(int mineLines, int theirsLines) {
            for (int i = 0; i < Math.max(mineLines, theirsLines); i++) {
                boolean left = i < mineLines;
                boolean right = i < theirsLines;
                all.add(new Row(left ? mineDone + 1 : 0, left ? mine.get(mineDone) : "",
                        right ? theirsDone + 1 : 0, right ? theirs.get(theirsDone) : ""));
                mineDone += left ? 1 : 0;
                theirsDone += right ? 1 : 0;
            }
        }
    }
}
