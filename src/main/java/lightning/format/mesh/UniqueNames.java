package lightning.format.mesh;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import lightning.base.text.PrintableText;

/** Generator of unique printable names from other programs' names. Not thread-safe. */
public final class UniqueNames {
    /** Maximum length in code points; leaves room for a number within the 100 that a scene allows. */
    private static final int MAX_LENGTH = 88;

    private final Set<String> used = new HashSet<>();
    private final Map<String, Integer> suffixes = new HashMap<>();

    /**
     * Returns the requested name or a similar free one: unprintable characters become {@code _}, spaces at the ends are
     * removed, and duplicates get a number.
     *
     * @param fallback name to use if nothing is left
     */
    public String unique(String requested, String fallback) {
        String printableName = printable(requested);
        String base = printableName.isEmpty() ? fallback : printableName;
        String name = base;
        while (!used.add(name)) {
            name = base + " " + suffixes.merge(base, 2, (number, _) -> number + 1);
        }
        return name;
    }

    private static String printable(String name) {
        var out = new StringBuilder();
        name.codePoints().limit(MAX_LENGTH)
                .map(c -> !PrintableText.isPrintable(c) || Character.getType(c) == Character.FORMAT ? '_'
                        : Character.getType(c) == Character.SPACE_SEPARATOR ? ' ' : c)
                .forEach(out::appendCodePoint);
        return out.toString().strip();
    }
}
