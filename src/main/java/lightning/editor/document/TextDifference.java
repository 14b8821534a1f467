package lightning.editor.document;

import com.github.difflib.algorithm.Change;
import com.github.difflib.algorithm.myers.MyersDiffWithLinearSpace;
import java.util.ArrayList;
import java.util.List;

/** Two texts line by line, side by side: lines that both have stand in one row. */
public final class TextDifference {
    /** The product of the numbers of lines that are compared at most. What differs more is told as all different. */
    private static final long MAX_PAIRS = 16L << 20;

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
        int commonHead = 0;
        while (commonHead < Math.min(a.size(), b.size()) && a.get(commonHead).equals(b.get(commonHead))) {
            commonHead++;
        }
        int commonTail = 0;
        while (commonTail < Math.min(a.size(), b.size()) - commonHead
                && a.get(a.size() - 1 - commonTail).equals(b.get(b.size() - 1 - commonTail))) {
            commonTail++;
        }
        List<String> middleA = a.subList(commonHead, a.size() - commonTail);
        List<String> middleB = b.subList(commonHead, b.size() - commonTail);
        var rows = new RowBuilder(a, b);
        rows.add(commonHead, commonHead);
        if ((long) middleA.size() * middleB.size() > MAX_PAIRS) {
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
        rows.add(commonTail, commonTail);
        return rows.rows;
    }

    /** Rows so far, and how many lines of each text they hold. */
    private static final class RowBuilder {
        private final List<Row> rows = new ArrayList<>();
        private final List<String> mine;
        private final List<String> theirs;
        private int mineCount;
        private int theirsCount;

        RowBuilder(List<String> mine, List<String> theirs) {
            this.mine = mine;
            this.theirs = theirs;
        }

        /** Adds lines of both texts side by side as far as there are some on both sides. */
        void add(int mineLines, int theirsLines) {
            for (int i = 0; i < Math.max(mineLines, theirsLines); i++) {
                boolean left = i < mineLines;
                boolean right = i < theirsLines;
                rows.add(new Row(left ? mineCount + 1 : 0, left ? mine.get(mineCount) : "",
                        right ? theirsCount + 1 : 0, right ? theirs.get(theirsCount) : ""));
                mineCount += left ? 1 : 0;
                theirsCount += right ? 1 : 0;
            }
        }
    }
}
