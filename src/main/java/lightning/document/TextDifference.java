package lightning.document;

import com.github.difflib.algorithm.Change;
import com.github.difflib.algorithm.myers.MyersDiffWithLinearSpace;
import java.util.ArrayList;
import java.util.List;

/** Side-by-side line diff of two texts; equal lines share a row. */
public final class TextDifference {
    /** Maximum product of the line counts to compare. Larger texts are reported as entirely different. */
    private static final long MAX_PAIRS = 16L << 20;

    private static final String GAP = " … ";
    private static final String END = " …";
    /** Characters that are kept of the start of a shortened line, and before its difference. */
    private static final int KEPT_START = 16;
    private static final int KEPT_BEFORE = 20;

    private TextDifference() {}

    /**
     * Row of the diff.
     *
     * @param mineLine   line number in the first text, from 1; 0 if none
     * @param mine       line without its end; empty if none
     * @param theirsLine line number in the second text, as {@code mineLine}
     */
    public record Row(int mineLine, String mine, int theirsLine, String theirs) {
        /** Returns whether both texts have the line. */
        public boolean isSame() {
            return mineLine > 0 && theirsLine > 0 && mine.equals(theirs);
        }

        /**
         * Returns the row with lines of at most a number of characters. Cuts equal text before the difference first, in both lines at the
         * same place, so that the difference stays visible.
         */
        public Row shortened(int characters) {
            if (Math.max(mine.length(), theirs.length()) <= characters) {
                return this;
            }
            int equal = isSame() ? 0 : commonPrefix(mine, theirs);
            int keptStart = Math.min(KEPT_START, characters / 4);
            int keptBefore = Math.min(KEPT_BEFORE, characters / 2 - GAP.length());
            int cut = equal - keptStart - keptBefore - GAP.length();
            return new Row(mineLine, shortened(mine, cut, keptStart, characters), theirsLine,
                    shortened(theirs, cut, keptStart, characters));
        }

        private static String shortened(String line, int cut, int keptStart, int characters) {
            String rest = cut <= 0 ? line : line.substring(0, keptStart) + GAP + line.substring(keptStart + cut + GAP.length());
            return rest.length() <= characters ? rest : rest.substring(0, Math.max(0, characters - END.length())) + END;
        }

        private static int commonPrefix(String a, String b) {
            int i = 0;
            while (i < Math.min(a.length(), b.length()) && a.charAt(i) == b.charAt(i)) {
                i++;
            }
            return i;
        }
    }

    /** Returns all lines of both texts in order, with as few differing rows as feasible. */
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
            // Merges adjacent changes, as the algorithm may split a changed block into single deletions and insertions.
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

    /** Rows so far, with the number of lines of each text in them. */
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

        /** Adds lines of both texts, side by side while both have any. */
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
