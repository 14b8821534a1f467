package lightning.base.text;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * How well a few typed letters fit a title: {@code ssa} fits <em>Save Scene As</em>. The letters must stand in the title in their
 * order, each word of the query for itself; letters that begin words and letters side by side count for more.
 */
public final class FuzzyMatch {
    private static final int LETTER_SCORE = 1;
    private static final int WORD_START_SCORE = 8;
    private static final int ADJACENT_SCORE = 5;
    private static final int NO_MATCH = Integer.MIN_VALUE / 2;

    private FuzzyMatch() {}

    /** How well they fit, the more the better; empty if they do not. A query without letters fits all alike. */
    public static OptionalInt score(String query, String title) {
        String letters = title.toLowerCase(Locale.ROOT);
        int sum = 0;
        for (String word : query.strip().toLowerCase(Locale.ROOT).split("\\s+")) {
            int wordScore = bestScore(word, letters);
            if (wordScore < 0) {
                return OptionalInt.empty();
            }
            sum += wordScore;
        }
        return OptionalInt.of(sum);
    }

    /** The same of a longer text, which must hold each word of the query as it is: 0 where it does. */
    public static OptionalInt containsWords(String query, String text) {
        String letters = text.toLowerCase(Locale.ROOT);
        return Stream.of(query.strip().toLowerCase(Locale.ROOT).split("\\s+")).allMatch(letters::contains) ? OptionalInt.of(0)
                : OptionalInt.empty();
    }

    /** The best of all ways to find the letters; below 0 where there is none. */
    private static int bestScore(String word, String title) {
        int n = title.length();
        // What the letters so far are worth where the last of them is at each place; and at most anywhere before that place.
        int[] ending = new int[n];
        int[] before = new int[n + 1];
        for (int i = 0; i < word.length(); i++) {
            int[] next = new int[n];
            int[] bestBefore = new int[n + 1];
            bestBefore[0] = NO_MATCH;
            for (int p = 0; p < n; p++) {
                next[p] = NO_MATCH;
                if (title.charAt(p) == word.charAt(i)) {
                    int separate = i == 0 ? 0 : before[p];
                    int adjacent = i > 0 && p > 0 ? ending[p - 1] + ADJACENT_SCORE : NO_MATCH;
                    next[p] = Math.max(separate, adjacent) + LETTER_SCORE + (beginsWord(title, p) ? WORD_START_SCORE : 0);
                }
                bestBefore[p + 1] = Math.max(bestBefore[p], next[p]);
            }
            ending = next;
            before = bestBefore;
        }
        return before[n];
    }

    private static boolean beginsWord(String title, int at) {
        return at == 0 || !Character.isLetterOrDigit(title.charAt(at - 1));
    }
}
