package lightning.format.mesh;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import lightning.base.text.Visible;

/** Names that a line shows and that are told apart, made of whatever other programs wrote. Not shared between threads. */
public final class PartNames {
    /** Code points; room for a number stays within the 100 that a scene allows. */
    private static final int LONGEST = 88;

    private final Set<String> taken = new HashSet<>();
    private final Map<String, Integer> last = new HashMap<>();

    /**
     * The wanted name, or the nearest that is free: what cannot be shown becomes {@code _}, spaces at the ends go, and a number
     * stands behind the second of a name.
     *
     * @param otherwise the name where nothing is left
     */
    public String unique(String wanted, String otherwise) {
        String shown = shown(wanted);
        String base = shown.isEmpty() ? otherwise : shown;
        String name = base;
        while (!taken.add(name)) {
            name = base + " " + last.merge(base, 2, (number, _) -> number + 1);
        }
        return name;
    }

    private static String shown(String wanted) {
        var out = new StringBuilder();
        wanted.codePoints().limit(LONGEST)
                .map(c -> !Visible.is(c) || Character.getType(c) == Character.FORMAT ? '_'
                        : Character.getType(c) == Character.SPACE_SEPARATOR ? ' ' : c)
                .forEach(out::appendCodePoint);
        return out.toString().strip();
    }
}
