package lightning.base.text;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * How well a few typed letters fit a title: {@code ssa} fits <em>Save Scene As</em>. The letters must stand in the title in their
 * order, each word of the query for itself; letters that begin words and letters side by side count for more.
 */
public final class Fuzzy {
    private static final int LETTER = 1;
    private static final int BEGINS_WORD = 8;
    private static final int BESIDE = 5;
    private static final int NONE = Integer.MIN_VALUE / 2;

    private Fuzzy() {}

    /** How well they fit, the more the better; empty if they do not. A query without letters fits all alike. */
    public static OptionalInt fit(String query, String title) {
        String letters = title.toLowerCase(Locale.ROOT);
        int sum = 0;
        for (String word : query.strip().toLowerCase(Locale.ROOT).split("\\s+")) {
            int fit = best(word, letters);
            if (fit < 0) {
                return OptionalInt.empty();
            }
            sum += fit;
        }
        return OptionalInt.of(sum);
    }

    /** The same of a longer text, which must hold each word of the query as it is: 0 where it does. */
    public static OptionalInt holds(String query, String text) {
        String letters = text.toLowerCase(Locale.ROOT);
        return Stream.of(query.strip().toLowerCase(Locale.ROOT).split("\\s+")).allMatch(letters::contains) ? OptionalInt.of(0)
                : OptionalInt.empty();
    }

    /** The best of all ways to find the letters; below 0 where there is none. */
    private static int best(String word, String title) {
        int n = title.length();
        // What the letters so far are worth where the last of them is at each place; and at most anywhere before that place.
        int[] ending = new int[n];
        int[] before = new int[n + 1];
        for (int i = 0; i < word.length(); i++) {
            int[] next = new int[n];
            int[] most = new int[n + 1];
            most[0] = NONE;
            for (int p = 0; p < n; p++) {
                next[p] = NONE;
                if (title.charAt(p) == word.charAt(i)) {
                    int apart = i == 0 ? 0 : before[p];
                    int beside = i > 0 && p > 0 ? ending[p - 1] + BESIDE : NONE;
                    next[p] = Math.max(apart, beside) + LETTER + (beginsWord(title, p) ? BEGINS_WORD : 0);
                }
                most[p + 1] = Math.max(most[p], next[p]);
            }
            ending = next;
            before = most;
        }
        return before[n];
    }

    private static boolean beginsWord(String title, int at) {
        return at == 0 || !Character.isLetterOrDigit(title.charAt(at - 1));
    }
}
