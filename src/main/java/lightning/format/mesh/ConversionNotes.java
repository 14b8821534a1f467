package lightning.format.mesh;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.text.PrintableText;

/** What a file holds that was left out, counted by its kind, so that nothing is dropped in silence. */
public final class ConversionNotes {
    /** So many kinds are told apart: a file may invent as many as it has bytes. */
    private static final int MAX_KINDS = 100;
    private static final String OTHER_KINDS = "others";

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** One more of a kind, named in the plural. */
    public void add(String kind) {
        add(kind, 1);
    }

    public void add(String kind, int count) {
        if (count > 0) {
            String printable = PrintableText.escape(kind);
            counts.merge(counts.size() < MAX_KINDS || counts.containsKey(printable) ? printable : OTHER_KINDS, count, Integer::sum);
        }
    }

    /** How many of each kind, named in one line, in the order in which they were found. */
    public Map<String, Integer> counts() {
        return counts;
    }
}
