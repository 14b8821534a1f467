package lightning.format.mesh;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import lightning.base.text.PrintableText;

/** Names that a line shows and that are told apart, made of whatever other programs wrote. Not shared between threads. */
public final class UniqueNames {
    /** Code points; room for a number stays within the 100 that a scene allows. */
    private static final int MAX_LENGTH = 88;

    private final Set<String> used = new HashSet<>();
    private final Map<String, Integer> suffixes = new HashMap<>();

    /**
     * The wanted name, or the nearest that is free: what cannot be shown becomes {@code _}, spaces at the ends go, and a number
     * stands behind the second of a name.
     *
     * @param fallback the name where nothing is left
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
