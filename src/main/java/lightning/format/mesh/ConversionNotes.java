package lightning.format.mesh;

import java.util.LinkedHashMap;
import java.util.Map;
import lightning.base.text.PrintableText;

/** Counts of omitted or approximated features by kind, so that nothing is dropped silently. */
public final class ConversionNotes {
    /** Maximum number of kinds, since a file may contain arbitrarily many. */
    private static final int MAX_KINDS = 100;
    private static final String OTHER_KINDS = "others";

    private final Map<String, Integer> counts = new LinkedHashMap<>();

    /** Counts one feature of a kind, named in the plural. */
    public void add(String kind) {
        add(kind, 1);
    }

    public void add(String kind, int count) {
        if (count > 0) {
            String printable = PrintableText.escape(kind);
            counts.merge(counts.size() < MAX_KINDS || counts.containsKey(printable) ? printable : OTHER_KINDS, count, Integer::sum);
        }
    }

    /** Returns the count of each kind, with one-line names, in order of first occurrence. */
    public Map<String, Integer> counts() {
        return counts;
    }
}
