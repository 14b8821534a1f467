package lightning.editor.document;

import java.util.ArrayList;
import java.util.List;

/** Two texts line by line, side by side: lines that both have stand in one row. */
public final class TextDifference {
    /** Cells of the table of a search for common lines: 64 MB. What differs more is told as all different. */
    private static final long MOST_CELLS = 16L << 20;

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
        var rows = new Rows(a, b);
        rows.same(head);
        middle(rows, a.subList(head, a.size() - tail), b.subList(head, b.size() - tail));
        rows.same(tail);
        return rows.all;
    }

    /** The longest common subsequence, by the table of its lengths for all ends of both lists. */
    private static void middle(Rows rows, List<String> a, List<String> b) {
        if ((long) a.size() * b.size() > MOST_CELLS) {
            rows.different(a.size(), b.size());
            return;
        }
        int[][] common = new int[a.size() + 1][b.size() + 1];
        for (int i = a.size() - 1; i >= 0; i--) {
            for (int j = b.size() - 1; j >= 0; j--) {
                common[i][j] = a.get(i).equals(b.get(j)) ? common[i + 1][j + 1] + 1
                        : Math.max(common[i + 1][j], common[i][j + 1]);
            }
        }
        int i = 0;
        int j = 0;
        int onlyA = 0;
        int onlyB = 0;
        while (i < a.size() && j < b.size()) {
            if (a.get(i).equals(b.get(j))) {
                rows.different(onlyA, onlyB);
                onlyA = 0;
                onlyB = 0;
                rows.same(1);
                i++;
                j++;
            } else if (common[i + 1][j] >= common[i][j + 1]) {
                onlyA++;
                i++;
            } else {
                onlyB++;
                j++;
            }
        }
        rows.different(onlyA + a.size() - i, onlyB + b.size() - j);
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

        void same(int lines) {
            different(lines, lines);
        }

        /** Lines that stand for each other as far as there are some on both sides. */
        void different(int mineLines, int theirsLines) {
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
