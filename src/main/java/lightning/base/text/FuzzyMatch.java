package lightning.base.text;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * Fuzzy search score of a few typed letters in a title: {@code ssa} matches <em>Save Scene As</em>. The letters of each query word must
 * occur in order. Letters at starts of words and adjacent letters score higher.
 */
public final class FuzzyMatch {
    private static final int LETTER_SCORE = 1;
    private static final int WORD_START_SCORE = 8;
    private static final int ADJACENT_SCORE = 5;
    private static final int NO_MATCH = Integer.MIN_VALUE / 2;

    private FuzzyMatch() {}

    /** Returns the score, higher for better matches; empty if there is no match. A query without letters matches every title equally. */
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

    /** Matches a longer text, which must contain each word of the query; the score is then 0. */
    public static OptionalInt containsWords(String query, String text) {
        String letters = text.toLowerCase(Locale.ROOT);
        return Stream.of(query.strip().toLowerCase(Locale.ROOT).split("\\s+")).allMatch(letters::contains) ? OptionalInt.of(0)
                : OptionalInt.empty();
    }

    /** Returns the best score of all alignments; below 0 if there is none. */
    private static int bestScore(String word, String title) {
        int n = title.length();
        // Best score with the last matched letter at each position, and the maximum before that position.
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
