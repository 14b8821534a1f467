package lightning.format.jen.asset;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.text.Quote;

/** Suggestions for misspelled words. */
public final class NameSuggestion {
    private static final int MAX_WORD_LENGTH = 40;
    private static final int MAX_CANDIDATES = 1000;

    private NameSuggestion() {}

    /**
     * Returns the candidate with the smallest edit distance to {@code word}, if at most a third of its letters (rounded)
     * differ. Only the first candidates are checked if there are very many.
     */
    public static Optional<String> closest(String word, Collection<String> candidates) {
        if (word.length() > MAX_WORD_LENGTH) {
            return Optional.empty();
        }
        String best = null;
        int minDistance = (word.length() + 1) / 3 + 1;
        for (String candidate : (Iterable<String>) candidates.stream().limit(MAX_CANDIDATES)::iterator) {
            if (Math.abs(candidate.length() - word.length()) < minDistance) {
                int distance = editDistance(word, candidate);
                if (distance < minDistance) {
                    minDistance = distance;
                    best = candidate;
                }
            }
        }
        return Optional.ofNullable(best);
    }

    /** Returns {@code ", did you mean 'intensity'?"}, or an empty string. */
    public static String hint(String word, Collection<String> candidates) {
        return closest(word, candidates).map(n -> ", did you mean " + Quote.of(n) + "?").orElse("");
    }

    /** Returns the optimal string alignment distance: insertions, deletions, replacements and swaps of neighbors. */
    private static int editDistance(String a, String b) {
        int[] secondLast = new int[b.length() + 1];
        int[] last = new int[b.length() + 1];
        Arrays.setAll(last, j -> j);
        for (int i = 1; i <= a.length(); i++) {
            int[] row = new int[b.length() + 1];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                boolean same = a.charAt(i - 1) == b.charAt(j - 1);
                row[j] = Math.min(Math.min(row[j - 1], last[j]) + 1, last[j - 1] + (same ? 0 : 1));
                if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
                    row[j] = Math.min(row[j], secondLast[j - 2] + 1);
                }
            }
            secondLast = last;
            last = row;
        }
        return last[b.length()];
    }

    /** Returns names for a message, without those that place a map, such as {@code coat_repeat} of {@code coat_map}. */
    public static String list(List<String> names) {
        return names.stream()
                .filter(name -> name.endsWith("_map") || !names.contains(name.substring(0, Math.max(0, name.lastIndexOf('_'))) + "_map"))
                .collect(Collectors.joining(", "));
    }
}
